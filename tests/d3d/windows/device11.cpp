// SPDX-License-Identifier: Apache-2.0
#include "devices.hpp"

#include <d3d11.h>

#include <cstring>

namespace d3d {

namespace {

constexpr DXGI_FORMAT format = DXGI_FORMAT_R32G32B32A32_FLOAT;

DXGI_FORMAT elementFormat(const std::string& type) {
    if (type == "float2") return DXGI_FORMAT_R32G32_FLOAT;
    if (type == "float3") return DXGI_FORMAT_R32G32B32_FLOAT;
    if (type == "float4") return DXGI_FORMAT_R32G32B32A32_FLOAT;
    if (type == "ubyte4") return DXGI_FORMAT_R8G8B8A8_UINT;
    throw Failure("there is no vertex element type " + type);
}

class Device11 final : public Device {
public:
    Device11() {
        const D3D_FEATURE_LEVEL level = D3D_FEATURE_LEVEL_11_0;
        check(D3D11CreateDevice(nullptr, D3D_DRIVER_TYPE_HARDWARE, nullptr, 0, &level, 1, D3D11_SDK_VERSION,
                                &device_, nullptr, &context_),
              "create a Direct3D 11 device");
    }

    std::string name() const override {
        ComPtr<IDXGIDevice> dxgi;
        ComPtr<IDXGIAdapter> adapter;
        DXGI_ADAPTER_DESC description{};
        check(device_.As(&dxgi), "find the adapter");
        check(dxgi->GetAdapter(&adapter), "find the adapter");
        check(adapter->GetDesc(&description), "name the adapter");
        std::string text;
        for (const wchar_t* c = description.Description; *c; ++c)
            text += static_cast<char>(*c);
        return text;
    }

    std::vector<Texels> run(const RunJob& job, const Code& code) override {
        context_->ClearState();
        const UINT use = job.compute ? UINT{D3D11_BIND_UNORDERED_ACCESS} : UINT{D3D11_BIND_RENDER_TARGET};
        std::vector<ComPtr<ID3D11Texture2D>> targets;
        for (const Texels& texels : job.targets)
            targets.push_back(image(job.width, job.height, texels, use));
        bindTextures(job);
        if (!job.parameters.empty()) bindParameters(job);
        if (job.compute)
            dispatch(job, code, targets);
        else
            draw(job, code, targets);
        context_->ClearState();
        std::vector<Texels> results;
        for (const auto& target : targets)
            results.push_back(read(job, target.Get()));
        return results;
    }

private:
    ComPtr<ID3D11Texture2D> image(int width, int height, const Texels& texels, UINT use) {
        D3D11_TEXTURE2D_DESC description{};
        description.Width = static_cast<UINT>(width);
        description.Height = static_cast<UINT>(height);
        description.MipLevels = description.ArraySize = description.SampleDesc.Count = 1;
        description.Format = format;
        description.BindFlags = use;
        const D3D11_SUBRESOURCE_DATA data{texels.data(), static_cast<UINT>(width) * 4 * UINT{sizeof(float)},
                                          0};
        ComPtr<ID3D11Texture2D> made;
        check(device_->CreateTexture2D(&description, &data, &made), "create an image");
        return made;
    }

    ComPtr<ID3D11Buffer> buffer(const std::vector<char>& bytes, UINT use, UINT stride = 0) {
        std::vector<char> padded = bytes;
        padded.resize((bytes.size() + 15) / 16 * 16); // constant buffers are whole registers
        D3D11_BUFFER_DESC description{};
        description.ByteWidth = static_cast<UINT>(padded.size());
        description.BindFlags = use;
        description.StructureByteStride = stride;
        description.MiscFlags = stride > 0 ? UINT{D3D11_RESOURCE_MISC_BUFFER_STRUCTURED} : 0;
        const D3D11_SUBRESOURCE_DATA data{padded.data(), 0, 0};
        ComPtr<ID3D11Buffer> made;
        check(device_->CreateBuffer(&description, &data, &made), "create a buffer");
        return made;
    }

    void bindTextures(const RunJob& job) {
        for (const TextureJob& texture : job.textures) {
            const auto from =
                image(texture.width, texture.height, texture.texels, D3D11_BIND_SHADER_RESOURCE);
            ComPtr<ID3D11ShaderResourceView> view;
            check(device_->CreateShaderResourceView(from.Get(), nullptr, &view), "view a texture");
            D3D11_SAMPLER_DESC description{};
            description.Filter =
                texture.linear ? D3D11_FILTER_MIN_MAG_LINEAR_MIP_POINT : D3D11_FILTER_MIN_MAG_MIP_POINT;
            description.AddressU = description.AddressV = description.AddressW = D3D11_TEXTURE_ADDRESS_CLAMP;
            description.MaxLOD = D3D11_FLOAT32_MAX;
            ComPtr<ID3D11SamplerState> sampler;
            check(device_->CreateSamplerState(&description, &sampler), "create a sampler");
            context_->PSSetShaderResources(texture.slot, 1, view.GetAddressOf());
            context_->PSSetSamplers(texture.slot, 1, sampler.GetAddressOf());
            context_->CSSetShaderResources(texture.slot, 1, view.GetAddressOf());
            context_->CSSetSamplers(texture.slot, 1, sampler.GetAddressOf());
        }
    }

    void bindParameters(const RunJob& job) {
        const auto parameters = buffer(job.parameters, D3D11_BIND_CONSTANT_BUFFER);
        context_->VSSetConstantBuffers(0, 1, parameters.GetAddressOf());
        context_->PSSetConstantBuffers(0, 1, parameters.GetAddressOf());
        context_->CSSetConstantBuffers(0, 1, parameters.GetAddressOf());
    }

    void bindVertices(const RunJob& job, ID3DBlob* vertexCode) {
        context_->IASetPrimitiveTopology(D3D11_PRIMITIVE_TOPOLOGY_TRIANGLELIST);
        for (const BufferJob& from : job.buffers) {
            const auto made = buffer(from.bytes, D3D11_BIND_SHADER_RESOURCE, from.stride);
            ComPtr<ID3D11ShaderResourceView> view;
            check(device_->CreateShaderResourceView(made.Get(), nullptr, &view), "view a buffer");
            context_->VSSetShaderResources(from.slot, 1, view.GetAddressOf());
        }
        if (job.elements.empty()) return;
        std::vector<D3D11_INPUT_ELEMENT_DESC> elements;
        for (const ElementJob& element : job.elements)
            elements.push_back({element.semantic.c_str(), 0, elementFormat(element.type), 0, element.offset,
                                D3D11_INPUT_PER_VERTEX_DATA, 0});
        ComPtr<ID3D11InputLayout> layout;
        check(device_->CreateInputLayout(elements.data(), static_cast<UINT>(elements.size()),
                                         vertexCode->GetBufferPointer(), vertexCode->GetBufferSize(),
                                         &layout),
              "create an input layout");
        context_->IASetInputLayout(layout.Get());
        const auto vertices = buffer(job.vertices, D3D11_BIND_VERTEX_BUFFER);
        const UINT stride = job.vertexStride, offset = 0;
        context_->IASetVertexBuffers(0, 1, vertices.GetAddressOf(), &stride, &offset);
    }

    void draw(const RunJob& job, const Code& code, const std::vector<ComPtr<ID3D11Texture2D>>& targets) {
        ID3DBlob *vertexCode = code(job.vertexShader), *fragmentCode = code(job.shader);
        ComPtr<ID3D11VertexShader> vertexShader;
        ComPtr<ID3D11PixelShader> fragmentShader;
        check(device_->CreateVertexShader(vertexCode->GetBufferPointer(), vertexCode->GetBufferSize(),
                                          nullptr, &vertexShader),
              "create the vertex shader " + job.vertexShader);
        check(device_->CreatePixelShader(fragmentCode->GetBufferPointer(), fragmentCode->GetBufferSize(),
                                         nullptr, &fragmentShader),
              "create the pixel shader " + job.shader);
        context_->VSSetShader(vertexShader.Get(), nullptr, 0);
        context_->PSSetShader(fragmentShader.Get(), nullptr, 0);
        bindVertices(job, vertexCode);
        std::vector<ComPtr<ID3D11RenderTargetView>> kept;
        std::vector<ID3D11RenderTargetView*> views;
        for (const auto& target : targets) {
            kept.emplace_back();
            check(device_->CreateRenderTargetView(target.Get(), nullptr, &kept.back()), "view a target");
            views.push_back(kept.back().Get());
        }
        context_->OMSetRenderTargets(static_cast<UINT>(views.size()), views.data(), nullptr);
        D3D11_RASTERIZER_DESC rasterizer{};
        rasterizer.FillMode = D3D11_FILL_SOLID;
        rasterizer.CullMode = D3D11_CULL_NONE;
        rasterizer.DepthClipEnable = TRUE;
        ComPtr<ID3D11RasterizerState> state;
        check(device_->CreateRasterizerState(&rasterizer, &state), "create a rasterizer state");
        context_->RSSetState(state.Get());
        const D3D11_VIEWPORT viewport{
            0.0f, 0.0f, static_cast<float>(job.width), static_cast<float>(job.height), 0.0f, 1.0f};
        context_->RSSetViewports(1, &viewport);
        context_->Draw(job.elements.empty() ? 3 : job.vertexCount(), 0);
    }

    void dispatch(const RunJob& job, const Code& code, const std::vector<ComPtr<ID3D11Texture2D>>& targets) {
        ID3DBlob* computeCode = code(job.shader);
        ComPtr<ID3D11ComputeShader> shader;
        check(device_->CreateComputeShader(computeCode->GetBufferPointer(), computeCode->GetBufferSize(),
                                           nullptr, &shader),
              "create the compute shader " + job.shader);
        context_->CSSetShader(shader.Get(), nullptr, 0);
        for (size_t i = 0; i < targets.size(); ++i) {
            ComPtr<ID3D11UnorderedAccessView> view;
            check(device_->CreateUnorderedAccessView(targets[i].Get(), nullptr, &view), "view a target");
            context_->CSSetUnorderedAccessViews(static_cast<UINT>(i), 1, view.GetAddressOf(), nullptr);
        }
        context_->Dispatch(job.groups[0], job.groups[1], 1);
    }

    Texels read(const RunJob& job, ID3D11Texture2D* from) {
        D3D11_TEXTURE2D_DESC description{};
        from->GetDesc(&description);
        description.Usage = D3D11_USAGE_STAGING;
        description.BindFlags = 0;
        description.CPUAccessFlags = D3D11_CPU_ACCESS_READ;
        ComPtr<ID3D11Texture2D> staging;
        check(device_->CreateTexture2D(&description, nullptr, &staging), "create a staging image");
        context_->CopyResource(staging.Get(), from);
        D3D11_MAPPED_SUBRESOURCE mapped{};
        check(context_->Map(staging.Get(), 0, D3D11_MAP_READ, 0, &mapped), "read an image");
        const size_t row = static_cast<size_t>(job.width) * 4;
        Texels texels(row * static_cast<size_t>(job.height));
        for (size_t y = 0; y < static_cast<size_t>(job.height); ++y)
            std::memcpy(texels.data() + y * row, static_cast<const char*>(mapped.pData) + y * mapped.RowPitch,
                        row * sizeof(float));
        context_->Unmap(staging.Get(), 0);
        return texels;
    }

    ComPtr<ID3D11Device> device_;
    ComPtr<ID3D11DeviceContext> context_;
};

} // namespace

std::unique_ptr<Device> openDevice11() {
    return std::make_unique<Device11>();
}

} // namespace d3d
