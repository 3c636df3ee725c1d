// SPDX-License-Identifier: Apache-2.0
#include "devices.hpp"

#include <d3d9.h>

#include <algorithm>
#include <cstring>

namespace d3d {

namespace {

// A16B16G16R16F targets truncate on the device that the tests use, so everything is 32-bit.
constexpr D3DFORMAT format = D3DFMT_A32B32G32R32F;

// The constant table, which the compiler puts in a comment of the code: tokens 'CTAB', then a header and
// entries whose offsets count from the header.
struct TableHeader {
    DWORD size, creator, version, constants, entries, flags, target;
};
struct TableEntry {
    DWORD name;
    WORD registerSet, firstRegister, registers, reserved;
    DWORD type, defaultValue;
};
constexpr WORD float4Set = 2;

// Null where there is none, as in a shader that reads no constant.
const char* constantTable(ID3DBlob* code) {
    const auto* token = static_cast<const DWORD*>(code->GetBufferPointer());
    const DWORD* end = token + code->GetBufferSize() / sizeof(DWORD);
    for (++token; token < end && (*token & D3DSI_OPCODE_MASK) == D3DSIO_COMMENT;) {
        const DWORD words = (*token & D3DSI_COMMENTSIZE_MASK) >> D3DSI_COMMENTSIZE_SHIFT;
        if (token[1] == MAKEFOURCC('C', 'T', 'A', 'B')) return reinterpret_cast<const char*>(token + 2);
        token += words + 1;
    }
    return nullptr;
}

// Calls visit(name, first register, registers) for each constant that the shader reads.
template <class Visit> void forConstants(ID3DBlob* code, Visit visit) {
    const char* table = constantTable(code);
    if (!table) return;
    TableHeader header;
    std::memcpy(&header, table, sizeof(header));
    for (DWORD i = 0; i < header.constants; ++i) {
        TableEntry entry;
        std::memcpy(&entry, table + header.entries + i * sizeof(entry), sizeof(entry));
        if (entry.registerSet == float4Set)
            visit(std::string(table + entry.name), entry.firstRegister, entry.registers);
    }
}

void copyRows(char* to, size_t pitch, const Texels& texels, int width, int height) {
    const size_t row = static_cast<size_t>(width) * 4 * sizeof(float);
    for (int y = 0; y < height; ++y)
        std::memcpy(to + static_cast<size_t>(y) * pitch,
                    reinterpret_cast<const char*>(texels.data()) + static_cast<size_t>(y) * row, row);
}

BYTE declarationType(const std::string& type) {
    if (type == "float2") return D3DDECLTYPE_FLOAT2;
    if (type == "float3") return D3DDECLTYPE_FLOAT3;
    if (type == "float4") return D3DDECLTYPE_FLOAT4;
    if (type == "ubyte4") return D3DDECLTYPE_UBYTE4;
    throw Failure("there is no vertex element type " + type);
}

BYTE declarationUsage(const std::string& semantic) {
    if (semantic == "POSITION") return D3DDECLUSAGE_POSITION;
    if (semantic == "BLENDINDICES") return D3DDECLUSAGE_BLENDINDICES;
    if (semantic == "BLENDWEIGHT") return D3DDECLUSAGE_BLENDWEIGHT;
    throw Failure("there is no vertex element " + semantic);
}

class Device9 final : public Device {
public:
    Device9() {
        direct3d_.Attach(Direct3DCreate9(D3D_SDK_VERSION));
        if (!direct3d_) throw Failure("there is no Direct3D 9");
        window_ = CreateWindowW(L"STATIC", L"d3d_run", WS_OVERLAPPEDWINDOW, 0, 0, 64, 64, nullptr, nullptr,
                                nullptr, nullptr);
        D3DPRESENT_PARAMETERS parameters{};
        parameters.Windowed = TRUE;
        parameters.SwapEffect = D3DSWAPEFFECT_DISCARD;
        parameters.BackBufferWidth = parameters.BackBufferHeight = 64;
        parameters.hDeviceWindow = window_;
        check(direct3d_->CreateDevice(D3DADAPTER_DEFAULT, D3DDEVTYPE_HAL, window_,
                                      D3DCREATE_HARDWARE_VERTEXPROCESSING, &parameters, &device_),
              "create a Direct3D 9 device");
    }
    ~Device9() override {
        device_.Reset();
        DestroyWindow(window_);
    }

    std::string name() const override {
        D3DADAPTER_IDENTIFIER9 identifier{};
        check(direct3d_->GetAdapterIdentifier(D3DADAPTER_DEFAULT, 0, &identifier), "name the adapter");
        return identifier.Description;
    }

    std::vector<Texels> run(const RunJob& job, const Code& code) override {
        if (job.compute) throw Failure("Direct3D 9 has no compute");
        std::vector<ComPtr<IDirect3DSurface9>> targets;
        for (const Texels& texels : job.targets)
            targets.push_back(target(job, texels));
        for (DWORD i = 0; i < 4; ++i)
            if (i > 0 || !targets.empty())
                check(device_->SetRenderTarget(i, i < targets.size() ? targets[i].Get() : nullptr),
                      "set a target");
        const auto textures = bindTextures(job);
        setStates();
        check(device_->BeginScene(), "begin a scene");
        draw(job, code);
        check(device_->EndScene(), "end a scene");
        std::vector<Texels> results;
        for (const auto& surface : targets)
            results.push_back(read(job, surface.Get()));
        return results;
    }

private:
    ComPtr<IDirect3DSurface9> systemSurface(const RunJob& job) {
        ComPtr<IDirect3DSurface9> surface;
        check(device_->CreateOffscreenPlainSurface(static_cast<UINT>(job.width),
                                                   static_cast<UINT>(job.height), format, D3DPOOL_SYSTEMMEM,
                                                   &surface, nullptr),
              "create a surface");
        return surface;
    }

    ComPtr<IDirect3DSurface9> target(const RunJob& job, const Texels& texels) {
        const auto source = systemSurface(job);
        D3DLOCKED_RECT locked{};
        check(source->LockRect(&locked, nullptr, 0), "lock a surface");
        copyRows(static_cast<char*>(locked.pBits), static_cast<size_t>(locked.Pitch), texels, job.width,
                 job.height);
        check(source->UnlockRect(), "unlock a surface");
        ComPtr<IDirect3DSurface9> surface;
        check(device_->CreateRenderTarget(static_cast<UINT>(job.width), static_cast<UINT>(job.height), format,
                                          D3DMULTISAMPLE_NONE, 0, FALSE, &surface, nullptr),
              "create a target");
        check(device_->UpdateSurface(source.Get(), nullptr, surface.Get(), nullptr), "fill a target");
        return surface;
    }

    std::vector<ComPtr<IDirect3DTexture9>> bindTextures(const RunJob& job) {
        std::vector<ComPtr<IDirect3DTexture9>> textures;
        for (const TextureJob& from : job.textures) {
            ComPtr<IDirect3DTexture9> texture;
            check(device_->CreateTexture(static_cast<UINT>(from.width), static_cast<UINT>(from.height), 1, 0,
                                         format, D3DPOOL_MANAGED, &texture, nullptr),
                  "create a texture");
            D3DLOCKED_RECT locked{};
            check(texture->LockRect(0, &locked, nullptr, 0), "lock a texture");
            copyRows(static_cast<char*>(locked.pBits), static_cast<size_t>(locked.Pitch), from.texels,
                     from.width, from.height);
            check(texture->UnlockRect(0), "unlock a texture");
            check(device_->SetTexture(from.slot, texture.Get()), "bind a texture");
            const DWORD filter = from.linear ? D3DTEXF_LINEAR : D3DTEXF_POINT;
            device_->SetSamplerState(from.slot, D3DSAMP_MINFILTER, filter);
            device_->SetSamplerState(from.slot, D3DSAMP_MAGFILTER, filter);
            device_->SetSamplerState(from.slot, D3DSAMP_MIPFILTER, D3DTEXF_NONE);
            device_->SetSamplerState(from.slot, D3DSAMP_ADDRESSU, D3DTADDRESS_CLAMP);
            device_->SetSamplerState(from.slot, D3DSAMP_ADDRESSV, D3DTADDRESS_CLAMP);
            textures.push_back(texture);
        }
        return textures;
    }

    void setStates() {
        device_->SetRenderState(D3DRS_ZENABLE, D3DZB_FALSE);
        device_->SetRenderState(D3DRS_CULLMODE, D3DCULL_NONE);
        device_->SetRenderState(D3DRS_ALPHABLENDENABLE, FALSE);
        device_->SetRenderState(D3DRS_ALPHATESTENABLE, FALSE);
        device_->SetRenderState(D3DRS_SRGBWRITEENABLE, FALSE);
    }

    // A constant that the shader reads and that the job does not give is an error.
    void setConstants(const RunJob& job, ID3DBlob* code, bool vertex) {
        forConstants(code, [&](const std::string& name, UINT first, UINT registers) {
            const auto given = std::ranges::find_if(job.constants, [&](const ConstantJob& constant) {
                return constant.vertex == vertex && constant.name == name;
            });
            if (given == job.constants.end()) throw Failure("the job gives no constant " + name);
            const UINT count = std::min(registers, static_cast<UINT>(given->registers.size() / 4));
            check(vertex ? device_->SetVertexShaderConstantF(first, given->registers.data(), count)
                         : device_->SetPixelShaderConstantF(first, given->registers.data(), count),
                  "set the constant " + name);
        });
    }

    ComPtr<IDirect3DVertexDeclaration9> declaration(const RunJob& job) {
        std::vector<D3DVERTEXELEMENT9> elements;
        for (const ElementJob& element : job.elements)
            elements.push_back({0, static_cast<WORD>(element.offset), declarationType(element.type),
                                D3DDECLMETHOD_DEFAULT, declarationUsage(element.semantic), 0});
        elements.push_back(D3DDECL_END());
        ComPtr<IDirect3DVertexDeclaration9> made;
        check(device_->CreateVertexDeclaration(elements.data(), &made), "create a vertex declaration");
        return made;
    }

    ComPtr<IDirect3DVertexBuffer9> vertexBuffer(const RunJob& job) {
        ComPtr<IDirect3DVertexBuffer9> buffer;
        const UINT bytes = static_cast<UINT>(job.vertices.size());
        check(device_->CreateVertexBuffer(bytes, D3DUSAGE_WRITEONLY, 0, D3DPOOL_MANAGED, &buffer, nullptr),
              "create a vertex buffer");
        void* mapped = nullptr;
        check(buffer->Lock(0, bytes, &mapped, 0), "lock a vertex buffer");
        std::memcpy(mapped, job.vertices.data(), bytes);
        check(buffer->Unlock(), "unlock a vertex buffer");
        return buffer;
    }

    void draw(const RunJob& job, const Code& code) {
        ID3DBlob *vertexCode = code(job.vertexShader), *fragmentCode = code(job.shader);
        ComPtr<IDirect3DVertexShader9> vertexShader;
        ComPtr<IDirect3DPixelShader9> fragmentShader;
        check(device_->CreateVertexShader(static_cast<const DWORD*>(vertexCode->GetBufferPointer()),
                                          &vertexShader),
              "create the vertex shader " + job.vertexShader);
        check(device_->CreatePixelShader(static_cast<const DWORD*>(fragmentCode->GetBufferPointer()),
                                         &fragmentShader),
              "create the pixel shader " + job.shader);
        check(device_->SetVertexShader(vertexShader.Get()), "set a vertex shader");
        check(device_->SetPixelShader(fragmentShader.Get()), "set a pixel shader");
        setConstants(job, vertexCode, true);
        setConstants(job, fragmentCode, false);
        const auto elements = declaration(job);
        check(device_->SetVertexDeclaration(elements.Get()), "set a vertex declaration");
        const auto vertices = vertexBuffer(job);
        check(device_->SetStreamSource(0, vertices.Get(), 0, job.vertexStride), "set a vertex buffer");
        check(device_->DrawPrimitive(D3DPT_TRIANGLELIST, 0, job.vertexCount() / 3), "draw");
    }

    Texels read(const RunJob& job, IDirect3DSurface9* from) {
        const auto surface = systemSurface(job);
        check(device_->GetRenderTargetData(from, surface.Get()), "read a target");
        D3DLOCKED_RECT locked{};
        check(surface->LockRect(&locked, nullptr, D3DLOCK_READONLY), "lock a surface");
        const size_t row = static_cast<size_t>(job.width) * 4;
        Texels texels(row * static_cast<size_t>(job.height));
        for (size_t y = 0; y < static_cast<size_t>(job.height); ++y)
            std::memcpy(texels.data() + y * row,
                        static_cast<const char*>(locked.pBits) + y * static_cast<size_t>(locked.Pitch),
                        row * sizeof(float));
        surface->UnlockRect();
        return texels;
    }

    HWND window_ = nullptr;
    ComPtr<IDirect3D9> direct3d_;
    ComPtr<IDirect3DDevice9> device_;
};

} // namespace

std::unique_ptr<Device> openDevice9() {
    return std::make_unique<Device9>();
}

} // namespace d3d
