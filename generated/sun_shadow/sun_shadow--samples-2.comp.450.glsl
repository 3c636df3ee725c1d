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
    vec2 _85 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _89 = _85 * parameters.gOutputSize.zw;
    vec2 _93 = parameters.gOutputSize.zw * 0.5;
    vec4 _96 = textureGather(gInCoarseDepth, fma(_85, parameters.gOutputSize.zw, -_93));
    vec4 _99 = textureGather(gInCoarseDepth, fma(_85, parameters.gOutputSize.zw, _93));
    float _100 = _96.y;
    float _103 = (_100 > 0.0) ? min(_100, 65504.0) : 65504.0;
    float _104 = _96.x;
    float _107 = (_104 > 0.0) ? min(_104, 65504.0) : 65504.0;
    float _108 = _96.z;
    float _111 = (_108 > 0.0) ? min(_108, 65504.0) : 65504.0;
    float _112 = _99.z;
    float _115 = (_112 > 0.0) ? min(_112, 65504.0) : 65504.0;
    float _116 = _99.x;
    float _119 = (_116 > 0.0) ? min(_116, 65504.0) : 65504.0;
    vec3 _123 = vec3(_89 * _103, _103);
    bvec2 _145 = greaterThan(_89, parameters.gOutputSize.zw);
    bvec2 _147 = lessThan(_89, vec2(1.0) - parameters.gOutputSize.zw);
    float _153 = _115 - _103;
    vec2 _161 = mix(vec2(_153, _115), vec2(_103 - _107, _107), bvec2((_145.x ? abs(_107 - _103) : 131008.0) < (_147.x ? abs(_153) : 65504.0)));
    float _167 = _119 - _103;
    vec2 _175 = mix(vec2(_167, _119), vec2(_103 - _111, _111), bvec2((_145.y ? abs(_111 - _103) : 131008.0) < (_147.y ? abs(_167) : 65504.0)));
    float _179 = _161.x;
    vec3 _186 = vec3((_89 * _179) + (vec2(parameters.gOutputSize.z, 0.0) * _161.y), _179);
    float _194 = _175.x;
    vec3 _201 = vec3((_89 * _194) + (vec2(0.0, parameters.gOutputSize.w) * _175.y), _194);
    vec3 _206 = cross(vec3(dot(parameters.gToShadowX.xyz, _186), dot(parameters.gToShadowY.xyz, _186), dot(parameters.gToShadowZ.xyz, _186)), vec3(dot(parameters.gToShadowX.xyz, _201), dot(parameters.gToShadowY.xyz, _201), dot(parameters.gToShadowZ.xyz, _201)));
    float _207 = _206.z;
    bool _231 = _103 > parameters.gCascadeFar.x;
    bvec3 _232 = bvec3(_231);
    bool _244 = _103 > parameters.gCascadeFar.y;
    bvec3 _245 = bvec3(_244);
    vec3 _246 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _232), parameters.gCascadeScale2.xyz, _245);
    float _249 = float(_231) + float(_244);
    vec3 _250 = fma(vec3(dot(parameters.gToShadowX.xyz, _123), dot(parameters.gToShadowY.xyz, _123), dot(parameters.gToShadowZ.xyz, _123)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _246, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _232), parameters.gCascadeOffset2.xyz, _245));
    float _251 = _246.z;
    vec2 _252 = _246.xy;
    vec2 _255 = clamp((-_206.xy) / vec2((abs(_207) > 9.9999996826552253889678874634872e-21) ? _207 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_251) / _252);
    vec2 _263 = max(parameters.gDisc.xy * _252, vec2(parameters.gDisc.z));
    vec2 _272 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _275 = floor(_85);
    vec2 _277 = floor(_275 * 0.5);
    vec2 _279 = _275 - (_277 * 2.0);
    vec2 _283 = _277 - (floor(_277 * 0.5) * 2.0);
    float _284 = _279.x;
    float _285 = _279.y;
    float _287 = abs(_284 - _285);
    float _288 = _283.y;
    float _293 = _283.x;
    vec2 _305 = vec2(fma(2.0, abs(_293 - _288), fma(8.0, _287, 4.0 * _285)) + _288, fma(2.0, abs(abs(_288 - _285) - _293), fma(4.0, _284, fma(-8.0, _287, 8.0))) + _293) * vec2(0.0625);
    float _310 = floor(parameters.gSubsetCount);
    float _313 = (_310 > 1.0) ? min(_310, 16.0) : 1.0;
    float _317 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _323 = vec2(0.509755313396453857421875, 0.13968057930469512939453125) * fma(-_313, floor((_317 + 0.5) / _313), _317);
    float _327 = 6.283185482025146484375 * (_323.x + _305.x);
    float _328 = cos(_327);
    float _329 = sin(_327);
    float _332 = _323.y + _305.y;
    vec2 _333 = fract(vec2(0.5));
    float _335 = 6.283185482025146484375 * _333.x;
    float _336 = cos(_335);
    float _337 = sin(_335);
    vec2 _353 = clamp(floor(fma(_263 * sqrt(fract(_333.y + _332)), vec2(fma(_336, _328, -(_337 * _329)), fma(_336, _329, _337 * _328)), _250.xy)) + vec2(0.5), vec2(0.5), _272);
    float _370 = -fma(parameters.gShadowBias.y, _103, parameters.gShadowBias.x);
    vec2 _374 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _376 = 6.283185482025146484375 * _374.x;
    float _377 = cos(_376);
    float _378 = sin(_376);
    vec2 _393 = clamp(floor(fma(_263 * sqrt(fract(_374.y + _332)), vec2(fma(_377, _328, -(_378 * _329)), fma(_377, _329, _378 * _328)), _250.xy)) + vec2(0.5), vec2(0.5), _272);
    imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_103 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_250.xy / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_103 <= parameters.gCascadeFar.z)) ? fma(-(float(textureLod(gInShadowMap, vec2(fma(_249, parameters.gCascadeSize.x, _353.x), _353.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_370, _251, min(_250.z + dot(_255, _353 - _250.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_249, parameters.gCascadeSize.x, _393.x), _393.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_370, _251, min(_250.z + dot(_255, _393 - _250.xy), 1.0)))), 0.5, 1.0) : 1.0) : 1.0, _103, 0.0, 0.0));
}

