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
    vec3 _142 = vec3(dot(parameters.gToShadowX.xyz, _121), dot(parameters.gToShadowY.xyz, _121), dot(parameters.gToShadowZ.xyz, _121)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w);
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
    vec2 _218 = clamp((-_204.xy) / vec2((abs(_205) > 9.9999996826552253889678874634872e-21) ? _205 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z));
    vec2 _227 = max(parameters.gDisc.xy, vec2(parameters.gDisc.z));
    vec2 _236 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _237 = floor(_83);
    vec2 _239 = floor(_237 * 0.5);
    vec2 _241 = _237 - (_239 * 2.0);
    vec2 _245 = _239 - (floor(_239 * 0.5) * 2.0);
    float _246 = _241.x;
    float _247 = _241.y;
    float _249 = abs(_246 - _247);
    float _250 = _245.y;
    float _255 = _245.x;
    vec2 _267 = vec2(fma(2.0, abs(_255 - _250), fma(8.0, _249, 4.0 * _247)) + _250, fma(2.0, abs(abs(_250 - _247) - _255), fma(4.0, _246, fma(-8.0, _249, 8.0))) + _255) * vec2(0.0625);
    float _272 = floor(parameters.gSubsetCount);
    float _275 = (_272 > 1.0) ? min(_272, 16.0) : 1.0;
    float _279 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _285 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_275, floor((_279 + 0.5) / _275), _279);
    float _289 = 6.283185482025146484375 * (_285.x + _267.x);
    float _290 = cos(_289);
    float _291 = sin(_289);
    float _294 = _285.y + _267.y;
    vec2 _295 = fract(vec2(0.5));
    float _297 = 6.283185482025146484375 * _295.x;
    float _298 = cos(_297);
    float _299 = sin(_297);
    vec2 _306 = _142.xy;
    vec2 _315 = clamp(floor(fma(_227 * sqrt(fract(_295.y + _294)), vec2(fma(_298, _290, -(_299 * _291)), fma(_298, _291, _299 * _290)), _306)) + vec2(0.5), vec2(0.5), _236);
    float _323 = _142.z;
    float _328 = -fma(parameters.gShadowBias.y, _101, parameters.gShadowBias.x);
    vec2 _332 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _334 = 6.283185482025146484375 * _332.x;
    float _335 = cos(_334);
    float _336 = sin(_334);
    vec2 _351 = clamp(floor(fma(_227 * sqrt(fract(_332.y + _294)), vec2(fma(_335, _290, -(_336 * _291)), fma(_335, _291, _336 * _290)), _306)) + vec2(0.5), vec2(0.5), _236);
    vec2 _364 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _366 = 6.283185482025146484375 * _364.x;
    float _367 = cos(_366);
    float _368 = sin(_366);
    vec2 _383 = clamp(floor(fma(_227 * sqrt(fract(_364.y + _294)), vec2(fma(_367, _290, -(_368 * _291)), fma(_367, _291, _368 * _290)), _306)) + vec2(0.5), vec2(0.5), _236);
    vec2 _396 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _398 = 6.283185482025146484375 * _396.x;
    float _399 = cos(_398);
    float _400 = sin(_398);
    vec2 _415 = clamp(floor(fma(_227 * sqrt(fract(_396.y + _294)), vec2(fma(_399, _290, -(_400 * _291)), fma(_399, _291, _400 * _290)), _306)) + vec2(0.5), vec2(0.5), _236);
    float _439 = (_101 < 65504.0) ? ((all(lessThanEqual(abs((_306 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_101 <= parameters.gCascadeFar.x)) ? fma(-(((float(textureLod(gInShadowMap, _315 * parameters.gCascadeSize.zw, 0.0).x < fma(_328, 1.0, min(_323 + dot(_218, _315 - _306), 1.0))) + float(textureLod(gInShadowMap, _351 * parameters.gCascadeSize.zw, 0.0).x < fma(_328, 1.0, min(_323 + dot(_218, _351 - _306), 1.0)))) + float(textureLod(gInShadowMap, _383 * parameters.gCascadeSize.zw, 0.0).x < fma(_328, 1.0, min(_323 + dot(_218, _383 - _306), 1.0)))) + float(textureLod(gInShadowMap, _415 * parameters.gCascadeSize.zw, 0.0).x < fma(_328, 1.0, min(_323 + dot(_218, _415 - _306), 1.0)))), 0.25, 1.0) : 1.0) : 1.0;
    imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_439, _101, 0.0, 0.0));
}

