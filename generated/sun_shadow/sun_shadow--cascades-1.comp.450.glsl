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
    vec3 _144 = vec3(dot(parameters.gToShadowX.xyz, _123), dot(parameters.gToShadowY.xyz, _123), dot(parameters.gToShadowZ.xyz, _123)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w);
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
    vec2 _220 = clamp((-_206.xy) / vec2((abs(_207) > 9.9999996826552253889678874634872e-21) ? _207 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z));
    vec2 _229 = max(parameters.gDisc.xy, vec2(parameters.gDisc.z));
    vec2 _238 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _239 = floor(_85);
    vec2 _241 = floor(_239 * 0.5);
    vec2 _243 = _239 - (_241 * 2.0);
    vec2 _247 = _241 - (floor(_241 * 0.5) * 2.0);
    float _248 = _243.x;
    float _249 = _243.y;
    float _251 = abs(_248 - _249);
    float _252 = _247.y;
    float _257 = _247.x;
    vec2 _269 = vec2(fma(2.0, abs(_257 - _252), fma(8.0, _251, 4.0 * _249)) + _252, fma(2.0, abs(abs(_252 - _249) - _257), fma(4.0, _248, fma(-8.0, _251, 8.0))) + _257) * vec2(0.0625);
    float _274 = floor(parameters.gSubsetCount);
    float _277 = (_274 > 1.0) ? min(_274, 16.0) : 1.0;
    float _281 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _287 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_277, floor((_281 + 0.5) / _277), _281);
    float _291 = 6.283185482025146484375 * (_287.x + _269.x);
    float _292 = cos(_291);
    float _293 = sin(_291);
    float _296 = _287.y + _269.y;
    vec2 _297 = fract(vec2(0.5));
    float _299 = 6.283185482025146484375 * _297.x;
    float _300 = cos(_299);
    float _301 = sin(_299);
    vec2 _308 = _144.xy;
    vec2 _317 = clamp(floor(fma(_229 * sqrt(fract(_297.y + _296)), vec2(fma(_300, _292, -(_301 * _293)), fma(_300, _293, _301 * _292)), _308)) + vec2(0.5), vec2(0.5), _238);
    float _325 = _144.z;
    float _330 = -fma(parameters.gShadowBias.y, _103, parameters.gShadowBias.x);
    vec2 _334 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _336 = 6.283185482025146484375 * _334.x;
    float _337 = cos(_336);
    float _338 = sin(_336);
    vec2 _353 = clamp(floor(fma(_229 * sqrt(fract(_334.y + _296)), vec2(fma(_337, _292, -(_338 * _293)), fma(_337, _293, _338 * _292)), _308)) + vec2(0.5), vec2(0.5), _238);
    vec2 _366 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _368 = 6.283185482025146484375 * _366.x;
    float _369 = cos(_368);
    float _370 = sin(_368);
    vec2 _385 = clamp(floor(fma(_229 * sqrt(fract(_366.y + _296)), vec2(fma(_369, _292, -(_370 * _293)), fma(_369, _293, _370 * _292)), _308)) + vec2(0.5), vec2(0.5), _238);
    vec2 _398 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _400 = 6.283185482025146484375 * _398.x;
    float _401 = cos(_400);
    float _402 = sin(_400);
    vec2 _417 = clamp(floor(fma(_229 * sqrt(fract(_398.y + _296)), vec2(fma(_401, _292, -(_402 * _293)), fma(_401, _293, _402 * _292)), _308)) + vec2(0.5), vec2(0.5), _238);
    float _440 = (_103 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_308 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_103 <= parameters.gCascadeFar.x)) ? fma(-(((float(textureLod(gInShadowMap, _317 * parameters.gCascadeSize.zw, 0.0).x < fma(_330, 1.0, min(_325 + dot(_220, _317 - _308), 1.0))) + float(textureLod(gInShadowMap, _353 * parameters.gCascadeSize.zw, 0.0).x < fma(_330, 1.0, min(_325 + dot(_220, _353 - _308), 1.0)))) + float(textureLod(gInShadowMap, _385 * parameters.gCascadeSize.zw, 0.0).x < fma(_330, 1.0, min(_325 + dot(_220, _385 - _308), 1.0)))) + float(textureLod(gInShadowMap, _417 * parameters.gCascadeSize.zw, 0.0).x < fma(_330, 1.0, min(_325 + dot(_220, _417 - _308), 1.0)))), 0.25, 1.0) : 1.0) : 1.0;
    imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_440, _103, 0.0, 0.0));
}

