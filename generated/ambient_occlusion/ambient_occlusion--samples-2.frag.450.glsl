#version 450

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    float gRadius;
    vec4 gTaps[32];
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _61 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _65 = parameters.gOutputSize.zw * 0.5;
    vec4 _68 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_65));
    vec4 _71 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _65));
    float _72 = _68.y;
    float _75 = (_72 > 0.0) ? min(_72, 65504.0) : 65504.0;
    float _76 = _68.x;
    float _79 = (_76 > 0.0) ? min(_76, 65504.0) : 65504.0;
    float _80 = _68.z;
    float _83 = (_80 > 0.0) ? min(_80, 65504.0) : 65504.0;
    float _84 = _71.z;
    float _87 = (_84 > 0.0) ? min(_84, 65504.0) : 65504.0;
    float _88 = _71.x;
    float _91 = (_88 > 0.0) ? min(_88, 65504.0) : 65504.0;
    bvec2 _92 = greaterThan(_61, parameters.gOutputSize.zw);
    bvec2 _94 = lessThan(_61, vec2(1.0) - parameters.gOutputSize.zw);
    float _100 = _87 - _75;
    vec2 _108 = mix(vec2(_100, _87), vec2(_75 - _79, _79), bvec2((_92.x ? abs(_79 - _75) : 131008.0) < (_94.x ? abs(_100) : 65504.0)));
    float _114 = _91 - _75;
    vec2 _122 = mix(vec2(_114, _91), vec2(_75 - _83, _83), bvec2((_92.y ? abs(_83 - _75) : 131008.0) < (_94.y ? abs(_114) : 65504.0)));
    vec2 _134 = vec2(_108.x, _122.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_108.y, _122.y));
    vec3 _142 = normalize(vec3(_134, (-1.0) - dot(fma(_61, parameters.gViewRay.xy, parameters.gViewRay.zw), _134)));
    vec2 _143 = floor(gl_FragCoord.xy);
    vec2 _145 = floor(_143 * 0.5);
    vec2 _147 = _143 - (_145 * 2.0);
    vec2 _151 = _145 - (floor(_145 * 0.5) * 2.0);
    float _152 = _147.x;
    float _153 = _147.y;
    float _155 = abs(_152 - _153);
    float _156 = _151.y;
    float _161 = _151.x;
    vec2 _173 = vec2(fma(2.0, abs(_161 - _156), fma(8.0, _155, 4.0 * _153)) + _156, fma(2.0, abs(abs(_156 - _153) - _161), fma(4.0, _152, fma(-8.0, _155, 8.0))) + _161) * vec2(0.0625);
    float _175 = 6.283185482025146484375 * _173.x;
    float _176 = cos(_175);
    float _177 = sin(_175);
    float _184 = 1.0 / max(fma(parameters.gOcclusionBias.y, _75, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _185 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _189 = vec3(_61 * _75, _75);
    float _190 = _142.z;
    float _192 = (_190 >= 0.0) ? 1.0 : (-1.0);
    float _194 = (-1.0) / (_192 + _190);
    float _195 = _142.x;
    float _196 = _142.y;
    float _198 = (_195 * _196) * _194;
    vec3 _205 = vec3(fma((_192 * _195) * _195, _194, 1.0), _192 * _198, (-_192) * _195);
    vec3 _209 = vec3(_198, fma(_196 * _196, _194, _192), -_196);
    vec3 _215 = ((_205 * _176) + (_209 * _177)) * parameters.gRadius;
    float _217 = _215.z;
    vec3 _223 = vec3((_215.xy - (parameters.gViewRay.zw * _217)) * _185, _217);
    vec3 _227 = ((_209 * _176) - (_205 * _177)) * parameters.gRadius;
    float _229 = _227.z;
    vec3 _235 = vec3((_227.xy - (parameters.gViewRay.zw * _229)) * _185, _229);
    vec3 _236 = _142 * parameters.gRadius;
    float _238 = _236.z;
    vec3 _244 = vec3((_236.xy - (parameters.gViewRay.zw * _238)) * _185, _238);
    float _256 = _173.y;
    vec3 _261 = _189 + ((((_223 * parameters.gTaps[0].x) + (_235 * parameters.gTaps[0].y)) + (_244 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _256)));
    float _262 = 1.0 / parameters.gRadius;
    float _264 = _261.z;
    vec2 _266 = _261.xy * (1.0 / _264);
    vec4 _274 = textureLod(gInCoarseDepth, _266, 0.0);
    float _275 = _274.x;
    float _279 = _264 - ((_275 > 0.0) ? min(_275, 65504.0) : 65504.0);
    vec3 _304 = _189 + ((((_223 * parameters.gTaps[1].x) + (_235 * parameters.gTaps[1].y)) + (_244 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _256)));
    float _306 = _304.z;
    vec2 _308 = _304.xy * (1.0 / _306);
    vec4 _316 = textureLod(gInCoarseDepth, _308, 0.0);
    float _317 = _316.x;
    float _321 = _306 - ((_317 > 0.0) ? min(_317, 65504.0) : 65504.0);
    vec2 _331 = mix(vec2(0.0), vec2(clamp(fma(_279, _184, -1.0), 0.0, 1.0) * clamp(fma(-_279, _262, 2.0), 0.0, 1.0), 1.0), bvec2((_264 > 0.0) && all(lessThanEqual(abs(_266 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_321, _184, -1.0), 0.0, 1.0) * clamp(fma(-_321, _262, 2.0), 0.0, 1.0), 1.0), bvec2((_306 > 0.0) && all(lessThanEqual(abs(_308 - vec2(0.5)), vec2(0.5)))));
    gOutOcclusion = vec4((_75 < 65504.0) ? (1.0 - (_331.x / max(_331.y, 1.0))) : 1.0, _75, 0.0, 0.0);
}

