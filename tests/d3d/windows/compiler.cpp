// SPDX-License-Identifier: Apache-2.0
#include "compiler.hpp"

#include <algorithm>

namespace d3d {

namespace {

std::string readFrom(const std::vector<fs::path>& roots, const fs::path& file) {
    for (const fs::path& root : roots) {
        std::error_code none;
        if (!fs::is_regular_file(root / file, none)) continue;
        const std::vector<char> bytes = readBytes(root / file);
        return {bytes.begin(), bytes.end()};
    }
    throw Failure("no root has the file " + file.string());
}

class Includes final : public ID3DInclude {
public:
    explicit Includes(const std::vector<fs::path>& roots) : roots_(roots) {}

    HRESULT STDMETHODCALLTYPE Open(D3D_INCLUDE_TYPE, const char* file, const void*, const void** data,
                                   UINT* bytes) override {
        try {
            const std::string text = readFrom(roots_, file);
            char* copy = new char[text.size()];
            std::copy(text.begin(), text.end(), copy);
            *data = copy;
            *bytes = static_cast<UINT>(text.size());
            return S_OK;
        } catch (const Failure&) {
            return E_FAIL;
        }
    }
    HRESULT STDMETHODCALLTYPE Close(const void* data) override {
        delete[] static_cast<const char*>(data);
        return S_OK;
    }

private:
    const std::vector<fs::path>& roots_;
};

std::vector<D3D_SHADER_MACRO> macrosOf(const Macros& macros) {
    std::vector<D3D_SHADER_MACRO> list;
    for (const auto& [name, value] : macros)
        list.push_back({name.c_str(), value.c_str()});
    list.push_back({nullptr, nullptr});
    return list;
}

std::string oneLine(ID3DBlob* messages) {
    if (!messages) return "the compiler said nothing";
    std::string text(static_cast<const char*>(messages->GetBufferPointer()), messages->GetBufferSize());
    std::erase_if(text, [](char c) { return c == '\r' || c == '\0'; });
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace

void check(HRESULT result, const std::string& what) {
    if (SUCCEEDED(result)) return;
    char code[16];
    std::snprintf(code, sizeof(code), "%08lx", static_cast<unsigned long>(result));
    throw Failure("could not " + what + " (" + code + ")");
}

ComPtr<ID3DBlob> compileText(const ShaderJob& job, const std::string& text) {
    const auto macros = macrosOf(job.macros);
    Includes includes(job.roots);
    ComPtr<ID3DBlob> code, messages;
    const HRESULT result =
        D3DCompile(text.data(), text.size(), job.file.c_str(), macros.data(), &includes, job.entry.c_str(),
                   job.profile.c_str(), D3DCOMPILE_OPTIMIZATION_LEVEL3, 0, &code, &messages);
    if (FAILED(result)) throw Failure(oneLine(messages.Get()));
    return code;
}

ComPtr<ID3DBlob> compile(const ShaderJob& job) {
    return compileText(job, readFrom(job.roots, job.file));
}

std::string preprocess(const HeaderJob& job) {
    const std::string text = readFrom(job.roots, job.file);
    const auto macros = macrosOf(job.macros);
    Includes includes(job.roots);
    ComPtr<ID3DBlob> expanded, messages;
    const HRESULT result = D3DPreprocess(text.data(), text.size(), job.file.c_str(), macros.data(), &includes,
                                         &expanded, &messages);
    if (FAILED(result)) throw Failure(oneLine(messages.Get()));
    return {static_cast<const char*>(expanded->GetBufferPointer()), expanded->GetBufferSize()};
}

} // namespace d3d
