// SPDX-License-Identifier: Apache-2.0
// A header's functions, found in its text as the compiler's preprocessor leaves it, and a shader that calls
// each: arguments come from interpolants and constants that the compiler does not know, every result reaches
// the output.
#include "compiler.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

namespace d3d {

namespace {

struct Declaration {
    std::string type, name, array; // array: "" or a count
    bool isOut = false;
};

struct Function {
    std::string type, name;
    std::vector<Declaration> parameters;
};

struct Text {
    std::map<std::string, std::vector<Declaration>> structs; // of the header and what it includes
    std::vector<Function> functions;                         // of the header alone
};

std::string trimmed(const std::string& text) {
    const size_t first = text.find_first_not_of(" \t\n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);)
        if (!trimmed(part).empty()) parts.push_back(trimmed(part));
    return parts;
}

Declaration declared(const std::string& type, const std::string& nameAndArray) {
    Declaration declaration{type, nameAndArray, {}};
    const size_t bracket = nameAndArray.find('[');
    if (bracket == std::string::npos) return declaration;
    declaration.name = trimmed(nameAndArray.substr(0, bracket));
    declaration.array = trimmed(nameAndArray.substr(bracket + 1, nameAndArray.find(']') - bracket - 1));
    return declaration;
}

// "row_major float4x4 a, b[2];" and the like.
std::vector<Declaration> membersOf(const std::string& body) {
    static const std::regex member(R"((?:row_major\s+)?(\w+)\s+([^:]+?)(?:\s*:\s*\w+)?)");
    std::vector<Declaration> members;
    for (const std::string& statement : split(body, ';')) {
        std::smatch match;
        if (!std::regex_match(statement, match, member)) throw Failure("not understood: " + statement);
        for (const std::string& name : split(match[2], ','))
            members.push_back(declared(match[1], name));
    }
    return members;
}

std::vector<Declaration> parametersOf(const std::string& list) {
    static const std::regex parameter(
        R"((in |out |inout )?\s*(\w+(?:< \w+>)?)\s+(\w+(?:\s*\[\s*\w+\s*\])?)(\s*=.*)?)");
    std::vector<Declaration> parameters;
    for (const std::string& each : split(list, ',')) {
        std::smatch match;
        if (!std::regex_match(each, match, parameter)) throw Failure("not understood: " + each);
        parameters.push_back(declared(match[2], match[3]));
        parameters.back().isOut = match[1] == "out " || match[1] == "inout ";
    }
    return parameters;
}

// The text without #line, and for each character whether the header itself has it. The preprocessor puts a
// blank around every token and writes paths with two backslashes.
struct Located {
    std::string text;
    std::vector<bool> own;
};

Located located(const std::string& preprocessed, const std::string& file) {
    static const std::regex angles(R"(\s*([<>])\s*)"), separators(R"([\\]+)");
    Located result;
    std::istringstream stream(preprocessed);
    bool own = true;
    for (std::string line; std::getline(stream, line);) {
        if (line.ends_with('\r')) line.pop_back();
        if (line.starts_with("#line")) {
            line = std::regex_replace(line, separators, "/");
            if (line.ends_with('"')) own = line.ends_with(file + '"');
            continue;
        }
        result.text += std::regex_replace(line, angles, "$1 ") + '\n';
        result.own.resize(result.text.size(), own);
    }
    return result;
}

size_t afterBlock(const std::string& text, size_t open) {
    int depth = 0;
    for (size_t i = open; i < text.size(); ++i) {
        depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
        if (depth == 0) return i + 1;
    }
    throw Failure("a block does not end");
}

Text parse(const Located& from) {
    static const std::regex structure(R"(struct\s+(\w+))"), function(R"((\w+)\s+(\w+)\s*\(([^)]*)\))");
    Text found;
    const std::string& text = from.text;
    for (size_t at = 0; at < text.size();) {
        const size_t end = text.find_first_of("{;", at);
        if (end == std::string::npos) break;
        const std::string head = trimmed(text.substr(at, end - at));
        if (text[end] == ';') {
            at = end + 1;
            continue;
        }
        const size_t after = afterBlock(text, end);
        const std::string body = text.substr(end + 1, after - end - 2);
        const bool hasValue = head.find('=') != std::string::npos; // a constant, an array of them
        std::smatch match;
        if (std::regex_match(head, match, structure))
            found.structs[match[1]] = membersOf(body);
        else if (std::regex_match(head, match, function)) {
            if (from.own[end]) found.functions.push_back({match[1], match[2], parametersOf(match[3])});
        } else if (!hasValue)
            throw Failure("not understood: " + head);
        at = after;
    }
    return found;
}

// Writes the body of a shader that calls one function.
class Call {
public:
    Call(const Text& text, const Function& function) : text_(text) {
        std::string arguments;
        for (const Declaration& parameter : function.parameters)
            arguments += (arguments.empty() ? "" : ", ") + argument(parameter);
        const std::string call = function.name + "(" + arguments + ")";
        if (function.type == "void")
            body_ << "    " << call << ";\n";
        else {
            body_ << "    " << function.type << " result = " << call << ";\n";
            outs_.push_back({function.type, "result", {}});
        }
        for (const Declaration& out : outs_)
            add(out.type, out.name, out.array);
    }
    std::string body() const { return body_.str(); }

private:
    std::string argument(const Declaration& parameter) {
        if (parameter.type == "sampler2D" || parameter.type.starts_with("Texture2D")) return "gTexture";
        if (parameter.type == "SamplerState") return "gTexture_sampler";
        const std::string name = "argument" + std::to_string(count_++);
        body_ << "    " << parameter.type << " " << name
              << (parameter.array.empty() ? "" : "[" + parameter.array + "]") << ";\n";
        fill(parameter.type, name, parameter.array);
        if (parameter.isOut) outs_.push_back({parameter.type, name, parameter.array});
        return name;
    }

    template <class Visit>
    static void forElements(const std::string& name, const std::string& array, Visit visit) {
        if (array.empty()) return visit(name);
        for (int i = 0; i < std::stoi(array); ++i)
            visit(name + "[" + std::to_string(i) + "]");
    }

    void fill(const std::string& type, const std::string& name, const std::string& array) {
        forElements(name, array, [&](const std::string& element) {
            if (const auto known = text_.structs.find(type); known != text_.structs.end())
                for (const Declaration& member : known->second)
                    fill(member.type, element + "." + member.name, member.array);
            else
                assign(type, element);
        });
    }

    // Seven interpolants and twenty constants: 140 different values.
    void assign(const std::string& type, const std::string& element) {
        const std::string part = swizzle(type);
        body_ << "    " << element << " = (" << type << ")(seed[" << seed_ % 7 << "]" << part << " * gSeed["
              << seed_ % 20 << "]" << part << ");\n";
        ++seed_;
    }

    void add(const std::string& type, const std::string& name, const std::string& array) {
        forElements(name, array, [&](const std::string& element) {
            if (const auto known = text_.structs.find(type); known != text_.structs.end())
                for (const Declaration& member : known->second)
                    add(member.type, element + "." + member.name, member.array);
            else
                body_ << "    sum += " << sumOf(type, element) << ";\n";
        });
    }

    static int components(const std::string& type) {
        const char last = type.back();
        return std::isdigit(static_cast<unsigned char>(last)) ? last - '0' : 1;
    }

    static bool isMatrix(const std::string& type) { return type.find('x') != std::string::npos; }

    static std::string swizzle(const std::string& type) {
        if (isMatrix(type)) return ".x"; // a scalar fills it
        return "." + std::string("xyzw").substr(0, static_cast<size_t>(components(type)));
    }

    static std::string sumOf(const std::string& type, const std::string& value) {
        if (isMatrix(type)) return "dot(mul(" + value + ", gSeed[0]), gSeed[1])";
        if (components(type) == 1) return "float(" + value + ")";
        const std::string count = std::to_string(components(type));
        return "dot((float" + count + ")" + value + ", (float" + count + ")1.0)";
    }

    const Text& text_;
    std::ostringstream body_;
    std::vector<Declaration> outs_;
    int count_ = 0, seed_ = 0;
};

std::string shaderText(const HeaderJob& job, const std::string& body) {
    const bool pairs = job.macros.contains("PLATFORM_D3D11") && job.macros.at("PLATFORM_D3D11") == "1";
    return "#include \"" + job.file + "\"\n" +
           (pairs
                ? "Texture2D<float4> gTexture : register(t0); SamplerState gTexture_sampler : register(s0);\n"
                : "sampler2D gTexture : register(s0);\n") +
           "float4 gSeed[20];\nfloat4 mainFragment(float4 seed[7] : TEXCOORD0) : SV_Target0 {\n    float sum "
           "= 0.0;\n" +
           body + "    return sum;\n}\n";
}

std::string signature(const Function& function) {
    std::string text = function.name + "(";
    for (const Declaration& parameter : function.parameters)
        text += (text.back() == '(' ? "" : ",") + parameter.type;
    std::erase(text, ' ');
    return text + ")";
}

} // namespace

std::vector<std::string> compileFunctions(const HeaderJob& job) {
    const Text text = parse(located(preprocess(job), job.file));
    std::vector<std::string> lines;
    for (const Function& function : text.functions) {
        const ShaderJob shader{function.name, job.profile, "mainFragment", job.file, job.roots, job.macros};
        try {
            compileText(shader, shaderText(job, Call(text, function).body()));
            lines.push_back(signature(function) + " ok");
        } catch (const Failure& failure) {
            lines.push_back(signature(function) + " failed " + failure.what());
        }
    }
    return lines;
}

} // namespace d3d
