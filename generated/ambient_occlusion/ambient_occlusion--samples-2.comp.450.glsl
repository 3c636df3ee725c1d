#version 450
layout(local_size_x = 32, local_size_y = 32, local_size_z = 1) in;

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    float gRadius;
    vec4 gTaps[32];
} parameters;

layout(binding = 16) uniform writeonly image2D gOutOcclusion;
layout(binding = 1) uniform sampler2D gInCoarseDepth;

void main()
{
    vec2 _64 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _68 = _64 * parameters.gOutputSize.zw;
    vec2 _72 = parameters.gOutputSize.zw * 0.5;
    vec4 _75 = textureGather(gInCoarseDepth, fma(_64, parameters.gOutputSize.zw, -_72));
    vec4 _78 = textureGather(gInCoarseDepth, fma(_64, parameters.gOutputSize.zw, _72));
    float _79 = _75.y;
    float _82 = (_79 > 0.0) ? min(_79, 65504.0) : 65504.0;
    float _83 = _75.x;
    float _86 = (_83 > 0.0) ? min(_83, 65504.0) : 65504.0;
    float _87 = _75.z;
    float _90 = (_87 > 0.0) ? min(_87, 65504.0) : 65504.0;
    float _91 = _78.z;
    float _94 = (_91 > 0.0) ? min(_91, 65504.0) : 65504.0;
    float _95 = _78.x;
    float _98 = (_95 > 0.0) ? min(_95, 65504.0) : 65504.0;
    bvec2 _99 = greaterThan(_68, parameters.gOutputSize.zw);
    bvec2 _101 = lessThan(_68, vec2(1.0) - parameters.gOutputSize.zw);
    float _107 = _94 - _82;
    vec2 _115 = mix(vec2(_107, _94), vec2(_82 - _86, _86), bvec2((_99.x ? abs(_86 - _82) : 131008.0) < (_101.x ? abs(_107) : 65504.0)));
    float _121 = _98 - _82;
    vec2 _129 = mix(vec2(_121, _98), vec2(_82 - _90, _90), bvec2((_99.y ? abs(_90 - _82) : 131008.0) < (_101.y ? abs(_121) : 65504.0)));
    vec2 _141 = vec2(_115.x, _129.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_115.y, _129.y));
    vec3 _149 = normalize(vec3(_141, (-1.0) - dot(fma(_68, parameters.gViewRay.xy, parameters.gViewRay.zw), _141)));
    vec2 _150 = floor(_64);
    vec2 _152 = floor(_150 * 0.5);
    vec2 _154 = _150 - (_152 * 2.0);
    vec2 _158 = _152 - (floor(_152 * 0.5) * 2.0);
    float _159 = _154.x;
    float _160 = _154.y;
    float _162 = abs(_159 - _160);
    float _163 = _158.y;
    float _168 = _158.x;
    vec2 _180 = vec2(fma(2.0, abs(_168 - _163), fma(8.0, _162, 4.0 * _160)) + _163, fma(2.0, abs(abs(_163 - _160) - _168), fma(4.0, _159, fma(-8.0, _162, 8.0))) + _168) * vec2(0.0625);
    float _182 = 6.283185482025146484375 * _180.x;
    float _183 = cos(_182);
    float _184 = sin(_182);
    float _191 = 1.0 / max(fma(parameters.gOcclusionBias.y, _82, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _192 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _196 = vec3(_68 * _82, _82);
    float _197 = _149.z;
    float _199 = (_197 >= 0.0) ? 1.0 : (-1.0);
    float _201 = (-1.0) / (_199 + _197);
    float _202 = _149.x;
    float _203 = _149.y;
    float _205 = (_202 * _203) * _201;
    vec3 _212 = vec3(fma((_199 * _202) * _202, _201, 1.0), _199 * _205, (-_199) * _202);
    vec3 _216 = vec3(_205, fma(_203 * _203, _201, _199), -_203);
    vec3 _222 = ((_212 * _183) + (_216 * _184)) * parameters.gRadius;
    float _224 = _222.z;
    vec3 _230 = vec3((_222.xy - (parameters.gViewRay.zw * _224)) * _192, _224);
    vec3 _234 = ((_216 * _183) - (_212 * _184)) * parameters.gRadius;
    float _236 = _234.z;
    vec3 _242 = vec3((_234.xy - (parameters.gViewRay.zw * _236)) * _192, _236);
    vec3 _243 = _149 * parameters.gRadius;
    float _245 = _243.z;
    vec3 _251 = vec3((_243.xy - (parameters.gViewRay.zw * _245)) * _192, _245);
    float _263 = _180.y;
    vec3 _268 = _196 + ((((_230 * parameters.gTaps[0].x) + (_242 * parameters.gTaps[0].y)) + (_251 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _263)));
    float _269 = 1.0 / parameters.gRadius;
    float _271 = _268.z;
    vec2 _273 = _268.xy * (1.0 / _271);
    vec4 _280 = textureLod(gInCoarseDepth, _273, 0.0);
    float _281 = _280.x;
    float _285 = _271 - ((_281 > 0.0) ? min(_281, 65504.0) : 65504.0);
    vec3 _310 = _196 + ((((_230 * parameters.gTaps[1].x) + (_242 * parameters.gTaps[1].y)) + (_251 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _263)));
    float _312 = _310.z;
    vec2 _314 = _310.xy * (1.0 / _312);
    vec4 _321 = textureLod(gInCoarseDepth, _314, 0.0);
    float _322 = _321.x;
    float _326 = _312 - ((_322 > 0.0) ? min(_322, 65504.0) : 65504.0);
    vec2 _336 = mix(vec2(0.0), vec2(clamp(fma(_285, _191, -1.0), 0.0, 1.0) * clamp(fma(-_285, _269, 2.0), 0.0, 1.0), 1.0), bvec2((_271 > 0.0) && all(lessThanEqual(floatBitsToUint(_273), uvec2(1065353216u))))) + mix(vec2(0.0), vec2(clamp(fma(_326, _191, -1.0), 0.0, 1.0) * clamp(fma(-_326, _269, 2.0), 0.0, 1.0), 1.0), bvec2((_312 > 0.0) && all(lessThanEqual(floatBitsToUint(_314), uvec2(1065353216u)))));
    imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_82 < 65504.0) ? (1.0 - (_336.x / max(_336.y, 1.0))) : 1.0, _82, 0.0, 0.0));
}

