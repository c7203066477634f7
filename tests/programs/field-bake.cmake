set(program field-bake)
