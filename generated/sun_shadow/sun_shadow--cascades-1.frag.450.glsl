#version 450

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

layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _85 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _89 = parameters.gOutputSize.zw * 0.5;
    vec4 _92 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_89));
    vec4 _95 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _89));
    float _96 = _92.y;
    float _99 = (_96 > 0.0) ? min(_96, 65504.0) : 65504.0;
    float _100 = _92.x;
    float _103 = (_100 > 0.0) ? min(_100, 65504.0) : 65504.0;
    float _104 = _92.z;
    float _107 = (_104 > 0.0) ? min(_104, 65504.0) : 65504.0;
    float _108 = _95.z;
    float _111 = (_108 > 0.0) ? min(_108, 65504.0) : 65504.0;
    float _112 = _95.x;
    float _115 = (_112 > 0.0) ? min(_112, 65504.0) : 65504.0;
    vec3 _119 = vec3(_85 * _99, _99);
    vec3 _140 = vec3(dot(parameters.gToShadowX.xyz, _119), dot(parameters.gToShadowY.xyz, _119), dot(parameters.gToShadowZ.xyz, _119)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w);
    bvec2 _141 = greaterThan(_85, parameters.gOutputSize.zw);
    bvec2 _143 = lessThan(_85, vec2(1.0) - parameters.gOutputSize.zw);
    float _149 = _111 - _99;
    vec2 _157 = mix(vec2(_149, _111), vec2(_99 - _103, _103), bvec2((_141.x ? abs(_103 - _99) : 131008.0) < (_143.x ? abs(_149) : 65504.0)));
    float _163 = _115 - _99;
    vec2 _171 = mix(vec2(_163, _115), vec2(_99 - _107, _107), bvec2((_141.y ? abs(_107 - _99) : 131008.0) < (_143.y ? abs(_163) : 65504.0)));
    float _175 = _157.x;
    vec3 _182 = vec3((_85 * _175) + (vec2(parameters.gOutputSize.z, 0.0) * _157.y), _175);
    float _190 = _171.x;
    vec3 _197 = vec3((_85 * _190) + (vec2(0.0, parameters.gOutputSize.w) * _171.y), _190);
    vec3 _202 = cross(vec3(dot(parameters.gToShadowX.xyz, _182), dot(parameters.gToShadowY.xyz, _182), dot(parameters.gToShadowZ.xyz, _182)), vec3(dot(parameters.gToShadowX.xyz, _197), dot(parameters.gToShadowY.xyz, _197), dot(parameters.gToShadowZ.xyz, _197)));
    float _203 = _202.z;
    vec2 _216 = clamp((-_202.xy) / vec2((abs(_203) > 9.9999996826552253889678874634872e-21) ? _203 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z));
    vec2 _225 = max(parameters.gDisc.xy, vec2(parameters.gDisc.z));
    vec2 _234 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _235 = floor(gl_FragCoord.xy);
    vec2 _237 = floor(_235 * 0.5);
    vec2 _239 = _235 - (_237 * 2.0);
    vec2 _243 = _237 - (floor(_237 * 0.5) * 2.0);
    float _244 = _239.x;
    float _245 = _239.y;
    float _247 = abs(_244 - _245);
    float _248 = _243.y;
    float _253 = _243.x;
    vec2 _265 = vec2(fma(2.0, abs(_253 - _248), fma(8.0, _247, 4.0 * _245)) + _248, fma(2.0, abs(abs(_248 - _245) - _253), fma(4.0, _244, fma(-8.0, _247, 8.0))) + _253) * vec2(0.0625);
    float _270 = floor(parameters.gSubsetCount);
    float _273 = (_270 > 1.0) ? min(_270, 16.0) : 1.0;
    float _277 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _283 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_273, floor((_277 + 0.5) / _273), _277);
    float _287 = 6.283185482025146484375 * (_283.x + _265.x);
    float _288 = cos(_287);
    float _289 = sin(_287);
    float _292 = _283.y + _265.y;
    vec2 _293 = fract(vec2(0.5));
    float _295 = 6.283185482025146484375 * _293.x;
    float _296 = cos(_295);
    float _297 = sin(_295);
    vec2 _304 = _140.xy;
    vec2 _313 = clamp(floor(fma(_225 * sqrt(fract(_293.y + _292)), vec2(fma(_296, _288, -(_297 * _289)), fma(_296, _289, _297 * _288)), _304)) + vec2(0.5), vec2(0.5), _234);
    float _321 = _140.z;
    float _326 = -fma(parameters.gShadowBias.y, _99, parameters.gShadowBias.x);
    vec2 _330 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _332 = 6.283185482025146484375 * _330.x;
    float _333 = cos(_332);
    float _334 = sin(_332);
    vec2 _349 = clamp(floor(fma(_225 * sqrt(fract(_330.y + _292)), vec2(fma(_333, _288, -(_334 * _289)), fma(_333, _289, _334 * _288)), _304)) + vec2(0.5), vec2(0.5), _234);
    vec2 _362 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _364 = 6.283185482025146484375 * _362.x;
    float _365 = cos(_364);
    float _366 = sin(_364);
    vec2 _381 = clamp(floor(fma(_225 * sqrt(fract(_362.y + _292)), vec2(fma(_365, _288, -(_366 * _289)), fma(_365, _289, _366 * _288)), _304)) + vec2(0.5), vec2(0.5), _234);
    vec2 _394 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _396 = 6.283185482025146484375 * _394.x;
    float _397 = cos(_396);
    float _398 = sin(_396);
    vec2 _413 = clamp(floor(fma(_225 * sqrt(fract(_394.y + _292)), vec2(fma(_397, _288, -(_398 * _289)), fma(_397, _289, _398 * _288)), _304)) + vec2(0.5), vec2(0.5), _234);
    float _436 = (_99 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_304 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_99 <= parameters.gCascadeFar.x)) ? fma(-(((float(textureLod(gInShadowMap, _313 * parameters.gCascadeSize.zw, 0.0).x < fma(_326, 1.0, min(_321 + dot(_216, _313 - _304), 1.0))) + float(textureLod(gInShadowMap, _349 * parameters.gCascadeSize.zw, 0.0).x < fma(_326, 1.0, min(_321 + dot(_216, _349 - _304), 1.0)))) + float(textureLod(gInShadowMap, _381 * parameters.gCascadeSize.zw, 0.0).x < fma(_326, 1.0, min(_321 + dot(_216, _381 - _304), 1.0)))) + float(textureLod(gInShadowMap, _413 * parameters.gCascadeSize.zw, 0.0).x < fma(_326, 1.0, min(_321 + dot(_216, _413 - _304), 1.0)))), 0.25, 1.0) : 1.0) : 1.0;
    gOutShadow = vec4(_436, _99, 0.0, 0.0);
}

