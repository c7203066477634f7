#include "vulkan.hpp"

#if !__has_include(<vulkan/vulkan.h>)

struct Vulkan::Functions {};
Vulkan::Vulkan() = default;
Vulkan::~Vulkan() = default;
std::unique_ptr<Vulkan> Vulkan::open(std::string& reason) {
  reason = "compiled without vulkan/vulkan.h (Debian package: libvulkan-dev)";
  return nullptr;
}
std::vector<std::uint32_t> Vulkan::compile(const std::string&) { return {}; }
std::vector<float> Vulkan::run(const std::vector<std::uint32_t>&, int, const std::vector<float>&, std::size_t,
                               unsigned) {
  return {};
}

#else

#define VK_NO_PROTOTYPES
#include <dlfcn.h>
#include <unistd.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace {

void check(VkResult result, const char* what) {
  if (result != VK_SUCCESS) throw VulkanError(std::string(what) + ": Vulkan error " + std::to_string(result));
}

}  // namespace

// The loader comes by dlopen, everything else by name: a program that finds none must still start.
struct Vulkan::Functions {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  VkCommandPool commands = VK_NULL_HANDLE;
  std::uint32_t family = 0;
  PFN_vkGetInstanceProcAddr get = nullptr;

#define ZONAL_VULKAN_FUNCTIONS(X)                                                                                     \
  X(DestroyInstance)                                                                                                  \
  X(EnumeratePhysicalDevices)                                                                                         \
  X(GetPhysicalDeviceProperties)                                                                                      \
  X(GetPhysicalDeviceQueueFamilyProperties) X(GetPhysicalDeviceMemoryProperties) X(CreateDevice) X(DestroyDevice)     \
      X(GetDeviceQueue) X(CreateCommandPool) X(DestroyCommandPool) X(CreateBuffer) X(DestroyBuffer)                   \
          X(GetBufferMemoryRequirements) X(AllocateMemory) X(FreeMemory) X(BindBufferMemory) X(MapMemory)             \
              X(CreateShaderModule) X(DestroyShaderModule) X(CreateDescriptorSetLayout) X(DestroyDescriptorSetLayout) \
                  X(CreatePipelineLayout) X(DestroyPipelineLayout) X(CreateComputePipelines) X(DestroyPipeline)       \
                      X(CreateDescriptorPool) X(DestroyDescriptorPool) X(AllocateDescriptorSets)                      \
                          X(UpdateDescriptorSets) X(AllocateCommandBuffers) X(FreeCommandBuffers)                     \
                              X(BeginCommandBuffer) X(EndCommandBuffer) X(CmdBindPipeline) X(CmdBindDescriptorSets)   \
                                  X(CmdDispatch) X(CmdPipelineBarrier) X(QueueSubmit) X(QueueWaitIdle)
#define ZONAL_VULKAN_DECLARE(name) PFN_vk##name name = nullptr;
  ZONAL_VULKAN_FUNCTIONS(ZONAL_VULKAN_DECLARE)
#undef ZONAL_VULKAN_DECLARE

  template <class F>
  void load(F& function, const char* name) {
    function = reinterpret_cast<F>(get(instance, name));
    if (function == nullptr) throw VulkanError(std::string("the driver has no ") + name);
  }
  void load_all() {
#define ZONAL_VULKAN_LOAD(name) load(name, "vk" #name);
    ZONAL_VULKAN_FUNCTIONS(ZONAL_VULKAN_LOAD)
#undef ZONAL_VULKAN_LOAD
  }

  /// A family of queues that compute; false where there is none.
  bool choose_family() {
    std::uint32_t count = 0;
    GetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    GetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    for (family = 0; family < count; ++family) {
      if (families[family].queueFlags & VK_QUEUE_COMPUTE_BIT) return true;
    }
    return false;
  }

  /// Memory that the program sees without flushing.
  std::uint32_t memory_type(std::uint32_t allowed) const {
    VkPhysicalDeviceMemoryProperties properties;
    GetPhysicalDeviceMemoryProperties(physical, &properties);
    const VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i) {
      if ((allowed >> i & 1U) != 0 && (properties.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    }
    throw VulkanError("no memory that the program can see");
  }
};

namespace {

/// What run() makes, and gives back however it ends.
template <class F>
class AtEnd {
 public:
  explicit AtEnd(F f) : f_(f) {}
  ~AtEnd() { f_(); }
  AtEnd(const AtEnd&) = delete;
  AtEnd& operator=(const AtEnd&) = delete;

 private:
  F f_;
};

}  // namespace

Vulkan::Vulkan() : vk_(std::make_unique<Functions>()) {}

Vulkan::~Vulkan() {
  if (vk_->commands != VK_NULL_HANDLE) vk_->DestroyCommandPool(vk_->device, vk_->commands, nullptr);
  if (vk_->device != VK_NULL_HANDLE) vk_->DestroyDevice(vk_->device, nullptr);
  if (vk_->instance != VK_NULL_HANDLE && vk_->DestroyInstance) vk_->DestroyInstance(vk_->instance, nullptr);
  // The library stays: some drivers do not survive their own unloading.
}

std::unique_ptr<Vulkan> Vulkan::open(std::string& reason) {
  std::unique_ptr<Vulkan> vulkan(new Vulkan);
  try {
    reason = vulkan->start();
  } catch (const VulkanError& error) {
    reason = error.what();
  }
  return reason.empty() ? std::move(vulkan) : nullptr;
}

std::string Vulkan::start() {
  void* const library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return "no libvulkan.so.1 (Debian packages: libvulkan1 mesa-vulkan-drivers)";
  vk_->get = reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library, "vkGetInstanceProcAddr"));
  if (vk_->get == nullptr) return "libvulkan.so.1 has no vkGetInstanceProcAddr";
  PFN_vkCreateInstance create_instance = nullptr;
  vk_->load(create_instance, "vkCreateInstance");
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.apiVersion = VK_API_VERSION_1_1;
  VkInstanceCreateInfo instance{};
  instance.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  instance.pApplicationInfo = &application;
  check(create_instance(&instance, nullptr, &vk_->instance), "making an instance");
  vk_->load_all();

  std::uint32_t count = 0;
  vk_->EnumeratePhysicalDevices(vk_->instance, &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vk_->EnumeratePhysicalDevices(vk_->instance, &count, devices.data());
  const auto properties_of = [&](VkPhysicalDevice device) {
    VkPhysicalDeviceProperties properties;
    vk_->GetPhysicalDeviceProperties(device, &properties);
    return properties;
  };
  std::stable_partition(devices.begin(), devices.end(), [&](VkPhysicalDevice device) {
    return properties_of(device).deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  });
  for (const VkPhysicalDevice physical : devices) {
    vk_->physical = physical;
    if (!vk_->choose_family()) continue;
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = vk_->family;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo device{};
    device.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    device.queueCreateInfoCount = 1;
    device.pQueueCreateInfos = &queue;
    if (vk_->CreateDevice(physical, &device, nullptr, &vk_->device) != VK_SUCCESS) continue;
    vk_->GetDeviceQueue(vk_->device, vk_->family, 0, &vk_->queue);
    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.queueFamilyIndex = vk_->family;
    check(vk_->CreateCommandPool(vk_->device, &pool, nullptr, &vk_->commands), "making a pool of commands");
    const VkPhysicalDeviceProperties properties = properties_of(physical);
    device_ = properties.deviceName;
    is_software_ = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    return "";
  }
  return "no Vulkan device that computes (Debian package: mesa-vulkan-drivers)";
}

std::vector<std::uint32_t> Vulkan::compile(const std::string& compute_shader) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("zonal_" + std::to_string(getpid()) + ".spv")).string();
  const std::string log = path + ".log";
  const AtEnd remove([&] { std::remove(path.c_str()), std::remove(log.c_str()); });
  const auto bytes_of = [](const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  FILE* const compiler =
      popen(("glslangValidator -V --stdin -S comp -o '" + path + "' > '" + log + "' 2>&1").c_str(), "w");
  if (compiler == nullptr) throw VulkanError("no glslangValidator");
  std::fwrite(compute_shader.data(), 1, compute_shader.size(), compiler);
  if (pclose(compiler) != 0) throw VulkanError("does not compile:\n" + bytes_of(log));
  const std::string bytes = bytes_of(path);
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  if (words.empty()) throw VulkanError("glslangValidator has written nothing");
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
  return words;
}

std::vector<float> Vulkan::run(const std::vector<std::uint32_t>& shader, int constant,
                               const std::vector<float>& numbers, std::size_t result_count, unsigned groups) {
  const Functions& vk = *vk_;
  const VkDevice device = vk.device;

  struct Buffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    float* numbers = nullptr;
  } buffers[2];
  const AtEnd free_buffers([&] {
    for (const Buffer& b : buffers) {
      vk.DestroyBuffer(device, b.buffer, nullptr);
      vk.FreeMemory(device, b.memory, nullptr);
    }
  });
  const std::size_t sizes[2] = {(std::max)(numbers.size(), std::size_t{1}), result_count};
  for (int i = 0; i < 2; ++i) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = sizes[i] * sizeof(float);
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    check(vk.CreateBuffer(device, &info, nullptr, &buffers[i].buffer), "making a buffer");
    VkMemoryRequirements needs;
    vk.GetBufferMemoryRequirements(device, buffers[i].buffer, &needs);
    VkMemoryAllocateInfo memory{};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    memory.allocationSize = needs.size;
    memory.memoryTypeIndex = vk.memory_type(needs.memoryTypeBits);
    check(vk.AllocateMemory(device, &memory, nullptr, &buffers[i].memory), "taking memory");
    check(vk.BindBufferMemory(device, buffers[i].buffer, buffers[i].memory, 0), "binding memory");
    void* mapped = nullptr;
    check(vk.MapMemory(device, buffers[i].memory, 0, VK_WHOLE_SIZE, 0, &mapped), "mapping memory");
    buffers[i].numbers = static_cast<float*>(mapped);
  }
  std::copy(numbers.begin(), numbers.end(), buffers[0].numbers);
  std::fill_n(buffers[1].numbers, result_count, std::numeric_limits<float>::quiet_NaN());

  VkDescriptorSetLayoutBinding bindings[2] = {};
  for (std::uint32_t i = 0; i < 2; ++i) {
    bindings[i].binding = i;
    bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    bindings[i].descriptorCount = 1;
    bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
  }
  VkDescriptorSetLayoutCreateInfo set_layout_info{};
  set_layout_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set_layout_info.bindingCount = 2;
  set_layout_info.pBindings = bindings;
  VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkShaderModule module = VK_NULL_HANDLE;
  VkPipeline pipeline = VK_NULL_HANDLE;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  const AtEnd free_pipeline([&] {
    vk.DestroyDescriptorPool(device, pool, nullptr);
    vk.DestroyPipeline(device, pipeline, nullptr);
    vk.DestroyShaderModule(device, module, nullptr);
    vk.DestroyPipelineLayout(device, layout, nullptr);
    vk.DestroyDescriptorSetLayout(device, set_layout, nullptr);
  });
  check(vk.CreateDescriptorSetLayout(device, &set_layout_info, nullptr, &set_layout), "describing buffers");
  VkPipelineLayoutCreateInfo layout_info{};
  layout_info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout_info.setLayoutCount = 1;
  layout_info.pSetLayouts = &set_layout;
  check(vk.CreatePipelineLayout(device, &layout_info, nullptr, &layout), "describing a pipeline");
  VkShaderModuleCreateInfo module_info{};
  module_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  module_info.codeSize = shader.size() * sizeof(std::uint32_t);
  module_info.pCode = shader.data();
  check(vk.CreateShaderModule(device, &module_info, nullptr, &module), "reading SPIR-V");
  VkComputePipelineCreateInfo pipeline_info{};
  pipeline_info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  pipeline_info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  pipeline_info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  pipeline_info.stage.module = module;
  pipeline_info.stage.pName = "main";
  const VkSpecializationMapEntry place{0, 0, sizeof constant};
  const VkSpecializationInfo specialization{1, &place, sizeof constant, &constant};
  pipeline_info.stage.pSpecializationInfo = &specialization;
  pipeline_info.layout = layout;
  check(vk.CreateComputePipelines(device, VK_NULL_HANDLE, 1, &pipeline_info, nullptr, &pipeline), "making a pipeline");

  const VkDescriptorPoolSize pool_size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
  VkDescriptorPoolCreateInfo pool_info{};
  pool_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool_info.maxSets = 1;
  pool_info.poolSizeCount = 1;
  pool_info.pPoolSizes = &pool_size;
  check(vk.CreateDescriptorPool(device, &pool_info, nullptr, &pool), "making a pool of descriptions");
  VkDescriptorSetAllocateInfo set_info{};
  set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  set_info.descriptorPool = pool;
  set_info.descriptorSetCount = 1;
  set_info.pSetLayouts = &set_layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  check(vk.AllocateDescriptorSets(device, &set_info, &set), "making a description");
  for (std::uint32_t i = 0; i < 2; ++i) {
    const VkDescriptorBufferInfo buffer_info{buffers[i].buffer, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set;
    write.dstBinding = i;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = &buffer_info;
    vk.UpdateDescriptorSets(device, 1, &write, 0, nullptr);
  }

  VkCommandBufferAllocateInfo commands_info{};
  commands_info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  commands_info.commandPool = vk.commands;
  commands_info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  commands_info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  check(vk.AllocateCommandBuffers(device, &commands_info, &commands), "making commands");
  const AtEnd free_commands([&] { vk.FreeCommandBuffers(device, vk.commands, 1, &commands); });
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vk.BeginCommandBuffer(commands, &begin), "beginning commands");
  vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
  vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
  vk.CmdDispatch(commands, groups, 1, 1);
  VkMemoryBarrier barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0,
                        nullptr, 0, nullptr);
  check(vk.EndCommandBuffer(commands), "ending commands");
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  check(vk.QueueSubmit(vk.queue, 1, &submit, VK_NULL_HANDLE), "submitting commands");
  check(vk.QueueWaitIdle(vk.queue), "waiting");
  return {buffers[1].numbers, buffers[1].numbers + result_count};
}

#endif
