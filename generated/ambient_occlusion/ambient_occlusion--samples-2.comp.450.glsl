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
    vec2 _62 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _66 = _62 * parameters.gOutputSize.zw;
    vec2 _70 = parameters.gOutputSize.zw * 0.5;
    vec4 _73 = textureGather(gInCoarseDepth, fma(_62, parameters.gOutputSize.zw, -_70));
    vec4 _76 = textureGather(gInCoarseDepth, fma(_62, parameters.gOutputSize.zw, _70));
    float _77 = _73.y;
    float _80 = (_77 > 0.0) ? min(_77, 65504.0) : 65504.0;
    float _81 = _73.x;
    float _84 = (_81 > 0.0) ? min(_81, 65504.0) : 65504.0;
    float _85 = _73.z;
    float _88 = (_85 > 0.0) ? min(_85, 65504.0) : 65504.0;
    float _89 = _76.z;
    float _92 = (_89 > 0.0) ? min(_89, 65504.0) : 65504.0;
    float _93 = _76.x;
    float _96 = (_93 > 0.0) ? min(_93, 65504.0) : 65504.0;
    bvec2 _97 = greaterThan(_66, parameters.gOutputSize.zw);
    bvec2 _99 = lessThan(_66, vec2(1.0) - parameters.gOutputSize.zw);
    float _105 = _92 - _80;
    vec2 _113 = mix(vec2(_105, _92), vec2(_80 - _84, _84), bvec2((_97.x ? abs(_84 - _80) : 131008.0) < (_99.x ? abs(_105) : 65504.0)));
    float _119 = _96 - _80;
    vec2 _127 = mix(vec2(_119, _96), vec2(_80 - _88, _88), bvec2((_97.y ? abs(_88 - _80) : 131008.0) < (_99.y ? abs(_119) : 65504.0)));
    vec2 _139 = vec2(_113.x, _127.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_113.y, _127.y));
    vec3 _147 = normalize(vec3(_139, (-1.0) - dot(fma(_66, parameters.gViewRay.xy, parameters.gViewRay.zw), _139)));
    vec2 _148 = floor(_62);
    vec2 _150 = floor(_148 * 0.5);
    vec2 _152 = _148 - (_150 * 2.0);
    vec2 _156 = _150 - (floor(_150 * 0.5) * 2.0);
    float _157 = _152.x;
    float _158 = _152.y;
    float _160 = abs(_157 - _158);
    float _161 = _156.y;
    float _166 = _156.x;
    vec2 _178 = vec2(fma(2.0, abs(_166 - _161), fma(8.0, _160, 4.0 * _158)) + _161, fma(2.0, abs(abs(_161 - _158) - _166), fma(4.0, _157, fma(-8.0, _160, 8.0))) + _166) * vec2(0.0625);
    float _180 = 6.283185482025146484375 * _178.x;
    float _181 = cos(_180);
    float _182 = sin(_180);
    float _189 = 1.0 / max(fma(parameters.gOcclusionBias.y, _80, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _190 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _194 = vec3(_66 * _80, _80);
    float _195 = _147.z;
    float _197 = (_195 >= 0.0) ? 1.0 : (-1.0);
    float _199 = (-1.0) / (_197 + _195);
    float _200 = _147.x;
    float _201 = _147.y;
    float _203 = (_200 * _201) * _199;
    vec3 _210 = vec3(fma((_197 * _200) * _200, _199, 1.0), _197 * _203, (-_197) * _200);
    vec3 _214 = vec3(_203, fma(_201 * _201, _199, _197), -_201);
    vec3 _220 = ((_210 * _181) + (_214 * _182)) * parameters.gRadius;
    float _222 = _220.z;
    vec3 _228 = vec3((_220.xy - (parameters.gViewRay.zw * _222)) * _190, _222);
    vec3 _232 = ((_214 * _181) - (_210 * _182)) * parameters.gRadius;
    float _234 = _232.z;
    vec3 _240 = vec3((_232.xy - (parameters.gViewRay.zw * _234)) * _190, _234);
    vec3 _241 = _147 * parameters.gRadius;
    float _243 = _241.z;
    vec3 _249 = vec3((_241.xy - (parameters.gViewRay.zw * _243)) * _190, _243);
    float _261 = _178.y;
    vec3 _266 = _194 + ((((_228 * parameters.gTaps[0].x) + (_240 * parameters.gTaps[0].y)) + (_249 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _261)));
    float _267 = 1.0 / parameters.gRadius;
    float _269 = _266.z;
    vec2 _271 = _266.xy * (1.0 / _269);
    vec4 _279 = textureLod(gInCoarseDepth, _271, 0.0);
    float _280 = _279.x;
    float _284 = _269 - ((_280 > 0.0) ? min(_280, 65504.0) : 65504.0);
    vec3 _309 = _194 + ((((_228 * parameters.gTaps[1].x) + (_240 * parameters.gTaps[1].y)) + (_249 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _261)));
    float _311 = _309.z;
    vec2 _313 = _309.xy * (1.0 / _311);
    vec4 _321 = textureLod(gInCoarseDepth, _313, 0.0);
    float _322 = _321.x;
    float _326 = _311 - ((_322 > 0.0) ? min(_322, 65504.0) : 65504.0);
    vec2 _336 = mix(vec2(0.0), vec2(clamp(fma(_284, _189, -1.0), 0.0, 1.0) * clamp(fma(-_284, _267, 2.0), 0.0, 1.0), 1.0), bvec2((_269 > 0.0) && all(lessThanEqual(abs(_271 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_326, _189, -1.0), 0.0, 1.0) * clamp(fma(-_326, _267, 2.0), 0.0, 1.0), 1.0), bvec2((_311 > 0.0) && all(lessThanEqual(abs(_313 - vec2(0.5)), vec2(0.5)))));
    imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_80 < 65504.0) ? (1.0 - (_336.x / max(_336.y, 1.0))) : 1.0, _80, 0.0, 0.0));
}

