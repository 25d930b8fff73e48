#include "sampler.h"

#include "result.h"

namespace aureole::vulkan {
namespace {

VkSamplerAddressMode address_mode(rhi::Address address) {
    return address == rhi::Address::repeat ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
}

}  // namespace

SamplerObject::SamplerObject(Context& context, const rhi::SamplerDesc& desc) : context_(context), desc_(desc) {
    const VkFilter filter = desc.filter == rhi::Filter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    VkSamplerCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = filter;
    info.minFilter = filter;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = address_mode(desc.address_u);
    info.addressModeV = address_mode(desc.address_v);
    info.addressModeW = address_mode(desc.address_w);
    check_result(context_.fn.vkCreateSampler(context_.device, &info, nullptr, &sampler_), "vkCreateSampler", "sampler");
}

SamplerObject::~SamplerObject() { context_.fn.vkDestroySampler(context_.device, sampler_, nullptr); }

}  // namespace aureole::vulkan
