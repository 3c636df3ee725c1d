#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform SunShadowParameters
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

uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _85 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _89 = textureLod(gInCoarseDepth, _85, 0.0);
    float _90 = _89.x;
    float _93 = (_90 > 0.0) ? min(_90, 65504.0) : 65504.0;
    vec2 _96 = vec2(parameters.gOutputSize.z, 0.0);
    vec4 _100 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_96), 0.0);
    float _101 = _100.x;
    float _104 = (_101 > 0.0) ? min(_101, 65504.0) : 65504.0;
    vec2 _107 = vec2(0.0, parameters.gOutputSize.w);
    vec4 _111 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_107), 0.0);
    float _112 = _111.x;
    float _115 = (_112 > 0.0) ? min(_112, 65504.0) : 65504.0;
    vec4 _118 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _96, 0.0);
    float _119 = _118.x;
    float _122 = (_119 > 0.0) ? min(_119, 65504.0) : 65504.0;
    vec4 _125 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _107, 0.0);
    float _126 = _125.x;
    float _129 = (_126 > 0.0) ? min(_126, 65504.0) : 65504.0;
    vec3 _133 = vec3(_85 * _93, _93);
    bvec2 _155 = greaterThan(_85, parameters.gOutputSize.zw);
    bvec2 _157 = lessThan(_85, vec2(1.0) - parameters.gOutputSize.zw);
    float _163 = _122 - _93;
    vec2 _168 = vec2(_93 - _104, _104);
    vec2 _169 = vec2(_163, _122);
    bvec2 _170 = bvec2((_155.x ? abs(_104 - _93) : 131008.0) < (_157.x ? abs(_163) : 65504.0));
    vec2 _171 = vec2(_170.x ? _168.x : _169.x, _170.y ? _168.y : _169.y);
    float _177 = _129 - _93;
    vec2 _182 = vec2(_93 - _115, _115);
    vec2 _183 = vec2(_177, _129);
    bvec2 _184 = bvec2((_155.y ? abs(_115 - _93) : 131008.0) < (_157.y ? abs(_177) : 65504.0));
    vec2 _185 = vec2(_184.x ? _182.x : _183.x, _184.y ? _182.y : _183.y);
    float _186 = _171.x;
    vec3 _193 = vec3((_85 * _186) + (_96 * _171.y), _186);
    float _198 = _185.x;
    vec3 _205 = vec3((_85 * _198) + (_107 * _185.y), _198);
    vec3 _210 = cross(vec3(dot(parameters.gToShadowX.xyz, _193), dot(parameters.gToShadowY.xyz, _193), dot(parameters.gToShadowZ.xyz, _193)), vec3(dot(parameters.gToShadowX.xyz, _205), dot(parameters.gToShadowY.xyz, _205), dot(parameters.gToShadowZ.xyz, _205)));
    float _211 = _210.z;
    bool _235 = _93 > parameters.gCascadeFar.x;
    bvec3 _236 = bvec3(_235);
    vec3 _237 = vec3(_236.x ? parameters.gCascadeScale1.xyz.x : vec3(1.0).x, _236.y ? parameters.gCascadeScale1.xyz.y : vec3(1.0).y, _236.z ? parameters.gCascadeScale1.xyz.z : vec3(1.0).z);
    vec3 _238 = vec3(_236.x ? parameters.gCascadeOffset1.xyz.x : vec3(0.0).x, _236.y ? parameters.gCascadeOffset1.xyz.y : vec3(0.0).y, _236.z ? parameters.gCascadeOffset1.xyz.z : vec3(0.0).z);
    bool _248 = _93 > parameters.gCascadeFar.y;
    bvec3 _249 = bvec3(_248);
    vec3 _250 = vec3(_249.x ? parameters.gCascadeScale2.xyz.x : _237.x, _249.y ? parameters.gCascadeScale2.xyz.y : _237.y, _249.z ? parameters.gCascadeScale2.xyz.z : _237.z);
    float _253 = float(_235) + float(_248);
    vec3 _254 = (vec3(dot(parameters.gToShadowX.xyz, _133), dot(parameters.gToShadowY.xyz, _133), dot(parameters.gToShadowZ.xyz, _133)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w)) * _250 + vec3(_249.x ? parameters.gCascadeOffset2.xyz.x : _238.x, _249.y ? parameters.gCascadeOffset2.xyz.y : _238.y, _249.z ? parameters.gCascadeOffset2.xyz.z : _238.z);
    float _255 = _250.z;
    vec2 _256 = _250.xy;
    vec2 _259 = clamp((-_210.xy) / vec2((abs(_211) > 9.9999996826552253889678874634872e-21) ? _211 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_255) / _256);
    vec2 _267 = max(parameters.gDisc.xy * _256, vec2(parameters.gDisc.z));
    vec2 _276 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _279 = floor(gl_FragCoord.xy);
    vec2 _281 = floor(_279 * 0.5);
    vec2 _283 = _279 - (_281 * 2.0);
    vec2 _287 = _281 - (floor(_281 * 0.5) * 2.0);
    float _288 = _283.x;
    float _289 = _283.y;
    float _291 = abs(_288 - _289);
    float _292 = _287.y;
    float _297 = _287.x;
    vec2 _309 = vec2((2.0 * abs(_297 - _292) + (8.0 * _291 + (4.0 * _289))) + _292, (2.0 * abs(abs(_292 - _289) - _297) + (4.0 * _288 + ((-8.0) * _291 + 8.0))) + _297) * vec2(0.0625);
    float _314 = floor(parameters.gSubsetCount);
    float _317 = (_314 > 1.0) ? min(_314, 16.0) : 1.0;
    float _321 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _327 = vec2(0.509755313396453857421875, 0.13968057930469512939453125) * ((-_317) * floor((_321 + 0.5) / _317) + _321);
    float _331 = 6.283185482025146484375 * (_327.x + _309.x);
    float _332 = cos(_331);
    float _333 = sin(_331);
    float _336 = _327.y + _309.y;
    vec2 _337 = fract(vec2(0.5));
    float _339 = 6.283185482025146484375 * _337.x;
    float _340 = cos(_339);
    float _341 = sin(_339);
    vec2 _348 = _254.xy;
    vec2 _357 = clamp(floor((_267 * sqrt(fract(_337.y + _336))) * vec2(_340 * _332 + (-(_341 * _333)), _340 * _333 + (_341 * _332)) + _348) + vec2(0.5), vec2(0.5), _276);
    float _369 = _254.z;
    float _374 = -(parameters.gShadowBias.y * _93 + parameters.gShadowBias.x);
    vec2 _378 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _380 = 6.283185482025146484375 * _378.x;
    float _381 = cos(_380);
    float _382 = sin(_380);
    vec2 _397 = clamp(floor((_267 * sqrt(fract(_378.y + _336))) * vec2(_381 * _332 + (-(_382 * _333)), _381 * _333 + (_382 * _332)) + _348) + vec2(0.5), vec2(0.5), _276);
    gOutShadow = vec4((_93 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_348 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_93 <= parameters.gCascadeFar.z)) ? ((-(float(textureLod(gInShadowMap, vec2(_253 * parameters.gCascadeSize.x + _357.x, _357.y) * parameters.gCascadeSize.zw, 0.0).x < (_374 * _255 + min(_369 + dot(_259, _357 - _348), 1.0))) + float(textureLod(gInShadowMap, vec2(_253 * parameters.gCascadeSize.x + _397.x, _397.y) * parameters.gCascadeSize.zw, 0.0).x < (_374 * _255 + min(_369 + dot(_259, _397 - _348), 1.0))))) * 0.5 + 1.0) : 1.0) : 1.0, _93, 0.0, 0.0);
}

