#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform SunShadowParameters
{
    vec4 gOutputSize;
    vec4 gToShadowX;
    vec4 gToShadowY;
    vec4 gToShadowZ;
    vec4 gCascadeScale1;
    vec4 gCascadeOffset1;
    vec4 gCascadeScale2;
    vec4 gCascadeOffset2;
    vec4 gCascadeScale3;
    vec4 gCascadeOffset3;
    vec4 gCascadeFar;
    vec4 gCascadeSize;
    vec3 gDisc;
    float gFrameIndex;
    vec3 gShadowBias;
    float gSubsetCount;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutShadow;
layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;

void main()
{
    vec2 _83 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _87 = _83 * parameters.gOutputSize.zw;
    vec2 _91 = parameters.gOutputSize.zw * 0.5;
    vec4 _94 = textureGather(gInCoarseDepth, fma(_83, parameters.gOutputSize.zw, -_91));
    vec4 _97 = textureGather(gInCoarseDepth, fma(_83, parameters.gOutputSize.zw, _91));
    float _98 = _94.y;
    float _101 = (_98 > 0.0) ? min(_98, 65504.0) : 65504.0;
    float _102 = _94.x;
    float _105 = (_102 > 0.0) ? min(_102, 65504.0) : 65504.0;
    float _106 = _94.z;
    float _109 = (_106 > 0.0) ? min(_106, 65504.0) : 65504.0;
    float _110 = _97.z;
    float _113 = (_110 > 0.0) ? min(_110, 65504.0) : 65504.0;
    float _114 = _97.x;
    float _117 = (_114 > 0.0) ? min(_114, 65504.0) : 65504.0;
    vec3 _121 = vec3(_87 * _101, _101);
    bvec2 _143 = greaterThan(_87, parameters.gOutputSize.zw);
    bvec2 _145 = lessThan(_87, vec2(1.0) - parameters.gOutputSize.zw);
    float _151 = _113 - _101;
    vec2 _159 = mix(vec2(_151, _113), vec2(_101 - _105, _105), bvec2((_143.x ? abs(_105 - _101) : 131008.0) < (_145.x ? abs(_151) : 65504.0)));
    float _165 = _117 - _101;
    vec2 _173 = mix(vec2(_165, _117), vec2(_101 - _109, _109), bvec2((_143.y ? abs(_109 - _101) : 131008.0) < (_145.y ? abs(_165) : 65504.0)));
    float _177 = _159.x;
    vec3 _184 = vec3((_87 * _177) + (vec2(parameters.gOutputSize.z, 0.0) * _159.y), _177);
    float _192 = _173.x;
    vec3 _199 = vec3((_87 * _192) + (vec2(0.0, parameters.gOutputSize.w) * _173.y), _192);
    vec3 _204 = cross(vec3(dot(parameters.gToShadowX.xyz, _184), dot(parameters.gToShadowY.xyz, _184), dot(parameters.gToShadowZ.xyz, _184)), vec3(dot(parameters.gToShadowX.xyz, _199), dot(parameters.gToShadowY.xyz, _199), dot(parameters.gToShadowZ.xyz, _199)));
    float _205 = _204.z;
    bool _229 = _101 > parameters.gCascadeFar.x;
    bvec3 _230 = bvec3(_229);
    bool _242 = _101 > parameters.gCascadeFar.y;
    bvec3 _243 = bvec3(_242);
    vec3 _244 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _230), parameters.gCascadeScale2.xyz, _243);
    float _247 = float(_229) + float(_242);
    vec3 _248 = fma(vec3(dot(parameters.gToShadowX.xyz, _121), dot(parameters.gToShadowY.xyz, _121), dot(parameters.gToShadowZ.xyz, _121)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _244, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _230), parameters.gCascadeOffset2.xyz, _243));
    float _249 = _244.z;
    vec2 _250 = _244.xy;
    vec2 _253 = clamp((-_204.xy) / vec2((abs(_205) > 9.9999996826552253889678874634872e-21) ? _205 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_249) / _250);
    vec2 _261 = max(parameters.gDisc.xy * _250, vec2(parameters.gDisc.z));
    vec2 _270 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _273 = floor(_83);
    vec2 _275 = floor(_273 * 0.5);
    vec2 _277 = _273 - (_275 * 2.0);
    vec2 _281 = _275 - (floor(_275 * 0.5) * 2.0);
    float _282 = _277.x;
    float _283 = _277.y;
    float _285 = abs(_282 - _283);
    float _286 = _281.y;
    float _291 = _281.x;
    vec2 _303 = vec2(fma(2.0, abs(_291 - _286), fma(8.0, _285, 4.0 * _283)) + _286, fma(2.0, abs(abs(_286 - _283) - _291), fma(4.0, _282, fma(-8.0, _285, 8.0))) + _291) * vec2(0.0625);
    float _308 = floor(parameters.gSubsetCount);
    float _311 = (_308 > 1.0) ? min(_308, 16.0) : 1.0;
    float _315 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _321 = vec2(0.509755313396453857421875, 0.13968057930469512939453125) * fma(-_311, floor((_315 + 0.5) / _311), _315);
    float _325 = 6.283185482025146484375 * (_321.x + _303.x);
    float _326 = cos(_325);
    float _327 = sin(_325);
    float _330 = _321.y + _303.y;
    vec2 _331 = fract(vec2(0.5));
    float _333 = 6.283185482025146484375 * _331.x;
    float _334 = cos(_333);
    float _335 = sin(_333);
    vec2 _351 = clamp(floor(fma(_261 * sqrt(fract(_331.y + _330)), vec2(fma(_334, _326, -(_335 * _327)), fma(_334, _327, _335 * _326)), _248.xy)) + vec2(0.5), vec2(0.5), _270);
    float _368 = -fma(parameters.gShadowBias.y, _101, parameters.gShadowBias.x);
    vec2 _372 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _374 = 6.283185482025146484375 * _372.x;
    float _375 = cos(_374);
    float _376 = sin(_374);
    vec2 _391 = clamp(floor(fma(_261 * sqrt(fract(_372.y + _330)), vec2(fma(_375, _326, -(_376 * _327)), fma(_375, _327, _376 * _326)), _248.xy)) + vec2(0.5), vec2(0.5), _270);
    imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_101 < 65504.0) ? ((all(lessThanEqual(abs((_248.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_101 <= parameters.gCascadeFar.z)) ? fma(-(float(textureLod(gInShadowMap, vec2(fma(_247, parameters.gCascadeSize.x, _351.x), _351.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_368, _249, min(_248.z + dot(_253, _351 - _248.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_247, parameters.gCascadeSize.x, _391.x), _391.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_368, _249, min(_248.z + dot(_253, _391 - _248.xy), 1.0)))), 0.5, 1.0) : 1.0) : 1.0, _101, 0.0, 0.0));
}

