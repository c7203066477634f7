# The newest entry of the changes but for what is unreleased, and the citation, are of the version in the header.
file(STRINGS ${source_dir}/CHANGELOG.md changes REGEX "^## [^,]*$" LIMIT_COUNT 1)
file(STRINGS ${source_dir}/CITATION.cff citation REGEX "^version: ")
foreach(line "${changes}" "${citation}")
  if(NOT line MATCHES "^(## |version: )${version}$")
    message(FATAL_ERROR "'${line}' is not of version ${version}")
  endif()
endforeach()
