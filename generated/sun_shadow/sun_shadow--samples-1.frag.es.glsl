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
    vec2 _79 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _83 = textureLod(gInCoarseDepth, _79, 0.0);
    float _84 = _83.x;
    float _87 = (_84 > 0.0) ? min(_84, 65504.0) : 65504.0;
    vec2 _90 = vec2(parameters.gOutputSize.z, 0.0);
    vec4 _94 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_90), 0.0);
    float _95 = _94.x;
    float _98 = (_95 > 0.0) ? min(_95, 65504.0) : 65504.0;
    vec2 _101 = vec2(0.0, parameters.gOutputSize.w);
    vec4 _105 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_101), 0.0);
    float _106 = _105.x;
    float _109 = (_106 > 0.0) ? min(_106, 65504.0) : 65504.0;
    vec4 _112 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _90, 0.0);
    float _113 = _112.x;
    float _116 = (_113 > 0.0) ? min(_113, 65504.0) : 65504.0;
    vec4 _119 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _101, 0.0);
    float _120 = _119.x;
    float _123 = (_120 > 0.0) ? min(_120, 65504.0) : 65504.0;
    vec3 _127 = vec3(_79 * _87, _87);
    bvec2 _149 = greaterThan(_79, parameters.gOutputSize.zw);
    bvec2 _151 = lessThan(_79, vec2(1.0) - parameters.gOutputSize.zw);
    float _157 = _116 - _87;
    vec2 _162 = vec2(_87 - _98, _98);
    vec2 _163 = vec2(_157, _116);
    bvec2 _164 = bvec2((_149.x ? abs(_98 - _87) : 131008.0) < (_151.x ? abs(_157) : 65504.0));
    vec2 _165 = vec2(_164.x ? _162.x : _163.x, _164.y ? _162.y : _163.y);
    float _171 = _123 - _87;
    vec2 _176 = vec2(_87 - _109, _109);
    vec2 _177 = vec2(_171, _123);
    bvec2 _178 = bvec2((_149.y ? abs(_109 - _87) : 131008.0) < (_151.y ? abs(_171) : 65504.0));
    vec2 _179 = vec2(_178.x ? _176.x : _177.x, _178.y ? _176.y : _177.y);
    float _180 = _165.x;
    vec3 _187 = vec3((_79 * _180) + (_90 * _165.y), _180);
    float _192 = _179.x;
    vec3 _199 = vec3((_79 * _192) + (_101 * _179.y), _192);
    vec3 _204 = cross(vec3(dot(parameters.gToShadowX.xyz, _187), dot(parameters.gToShadowY.xyz, _187), dot(parameters.gToShadowZ.xyz, _187)), vec3(dot(parameters.gToShadowX.xyz, _199), dot(parameters.gToShadowY.xyz, _199), dot(parameters.gToShadowZ.xyz, _199)));
    float _205 = _204.z;
    bool _229 = _87 > parameters.gCascadeFar.x;
    bvec3 _230 = bvec3(_229);
    vec3 _231 = vec3(_230.x ? parameters.gCascadeScale1.xyz.x : vec3(1.0).x, _230.y ? parameters.gCascadeScale1.xyz.y : vec3(1.0).y, _230.z ? parameters.gCascadeScale1.xyz.z : vec3(1.0).z);
    vec3 _232 = vec3(_230.x ? parameters.gCascadeOffset1.xyz.x : vec3(0.0).x, _230.y ? parameters.gCascadeOffset1.xyz.y : vec3(0.0).y, _230.z ? parameters.gCascadeOffset1.xyz.z : vec3(0.0).z);
    bool _242 = _87 > parameters.gCascadeFar.y;
    bvec3 _243 = bvec3(_242);
    vec3 _244 = vec3(_243.x ? parameters.gCascadeScale2.xyz.x : _231.x, _243.y ? parameters.gCascadeScale2.xyz.y : _231.y, _243.z ? parameters.gCascadeScale2.xyz.z : _231.z);
    vec3 _248 = (vec3(dot(parameters.gToShadowX.xyz, _127), dot(parameters.gToShadowY.xyz, _127), dot(parameters.gToShadowZ.xyz, _127)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w)) * _244 + vec3(_243.x ? parameters.gCascadeOffset2.xyz.x : _232.x, _243.y ? parameters.gCascadeOffset2.xyz.y : _232.y, _243.z ? parameters.gCascadeOffset2.xyz.z : _232.z);
    float _249 = _244.z;
    vec2 _250 = _244.xy;
    vec2 _273 = floor(gl_FragCoord.xy);
    vec2 _275 = floor(_273 * 0.5);
    vec2 _277 = _273 - (_275 * 2.0);
    vec2 _281 = _275 - (floor(_275 * 0.5) * 2.0);
    float _282 = _277.x;
    float _283 = _277.y;
    float _285 = abs(_282 - _283);
    float _286 = _281.y;
    float _291 = _281.x;
    vec2 _303 = vec2((2.0 * abs(_291 - _286) + (8.0 * _285 + (4.0 * _283))) + _286, (2.0 * abs(abs(_286 - _283) - _291) + (4.0 * _282 + ((-8.0) * _285 + 8.0))) + _291) * vec2(0.0625);
    float _308 = floor(parameters.gSubsetCount);
    float _311 = (_308 > 1.0) ? min(_308, 16.0) : 1.0;
    float _315 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _321 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * ((-_311) * floor((_315 + 0.5) / _311) + _315);
    float _325 = 6.283185482025146484375 * (_321.x + _303.x);
    float _326 = cos(_325);
    float _327 = sin(_325);
    vec2 _331 = fract(vec2(0.5));
    float _333 = 6.283185482025146484375 * _331.x;
    float _334 = cos(_333);
    float _335 = sin(_333);
    vec2 _342 = _248.xy;
    vec2 _351 = clamp(floor((max(parameters.gDisc.xy * _250, vec2(parameters.gDisc.z)) * sqrt(fract(_331.y + (_321.y + _303.y)))) * vec2(_334 * _326 + (-(_335 * _327)), _334 * _327 + (_335 * _326)) + _342) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
    float _382 = (_87 < 65504.0) ? ((all(lessThanEqual(abs((_342 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_87 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2((float(_229) + float(_242)) * parameters.gCascadeSize.x + _351.x, _351.y) * parameters.gCascadeSize.zw, 0.0).x < ((-(parameters.gShadowBias.y * _87 + parameters.gShadowBias.x)) * _249 + min(_248.z + dot(clamp((-_204.xy) / vec2((abs(_205) > 9.9999996826552253889678874634872e-21) ? _205 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_249) / _250), _351 - _342), 1.0)))) : 1.0) : 1.0;
    gOutShadow = vec4(_382, _87, 0.0, 0.0);
}

