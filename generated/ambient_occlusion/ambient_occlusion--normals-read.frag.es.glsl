#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    float gRadius;
    vec4 gTaps[32];
} parameters;

uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInNormal;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _70 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _74 = textureLod(gInCoarseDepth, _70, 0.0);
    float _75 = _74.x;
    float _78 = (_75 > 0.0) ? min(_75, 65504.0) : 65504.0;
    vec3 _89 = textureLod(gInNormal, (gl_FragCoord.xy * parameters.gOutputSize.zw + (-(parameters.gOutputSize.zw * 0.125))) / parameters.gFrameToCoarse, 0.0).xyz;
    float _90 = dot(_89, _89);
    vec3 _95 = _89 * inversesqrt(_90);
    bvec3 _96 = bvec3((_90 > 9.9999999747524270787835121154785e-07) && (_90 < 1000000.0));
    vec3 _97 = vec3(_96.x ? _95.x : vec3(0.0, 0.0, -1.0).x, _96.y ? _95.y : vec3(0.0, 0.0, -1.0).y, _96.z ? _95.z : vec3(0.0, 0.0, -1.0).z);
    vec2 _98 = floor(gl_FragCoord.xy);
    vec2 _100 = floor(_98 * 0.5);
    vec2 _102 = _98 - (_100 * 2.0);
    vec2 _106 = _100 - (floor(_100 * 0.5) * 2.0);
    float _107 = _102.x;
    float _108 = _102.y;
    float _110 = abs(_107 - _108);
    float _111 = _106.y;
    float _116 = _106.x;
    vec2 _128 = vec2((2.0 * abs(_116 - _111) + (8.0 * _110 + (4.0 * _108))) + _111, (2.0 * abs(abs(_111 - _108) - _116) + (4.0 * _107 + ((-8.0) * _110 + 8.0))) + _116) * vec2(0.0625);
    float _130 = 6.283185482025146484375 * _128.x;
    float _131 = cos(_130);
    float _132 = sin(_130);
    float _139 = 1.0 / max(parameters.gOcclusionBias.y * _78 + parameters.gOcclusionBias.x, 9.9999999747524270787835121154785e-07);
    vec2 _143 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _147 = vec3(_70 * _78, _78);
    float _148 = _97.z;
    float _150 = (_148 >= 0.0) ? 1.0 : (-1.0);
    float _152 = (-1.0) / (_150 + _148);
    float _153 = _97.x;
    float _154 = _97.y;
    float _156 = (_153 * _154) * _152;
    vec3 _163 = vec3(((_150 * _153) * _153) * _152 + 1.0, _150 * _156, (-_150) * _153);
    vec3 _167 = vec3(_156, (_154 * _154) * _152 + _150, -_154);
    vec3 _173 = ((_163 * _131) + (_167 * _132)) * parameters.gRadius;
    float _176 = _173.z;
    vec3 _182 = vec3((_173.xy - (parameters.gViewRay.zw * _176)) * _143, _176);
    vec3 _186 = ((_167 * _131) - (_163 * _132)) * parameters.gRadius;
    float _188 = _186.z;
    vec3 _194 = vec3((_186.xy - (parameters.gViewRay.zw * _188)) * _143, _188);
    vec3 _195 = _97 * parameters.gRadius;
    float _197 = _195.z;
    vec3 _203 = vec3((_195.xy - (parameters.gViewRay.zw * _197)) * _143, _197);
    float _215 = _128.y;
    vec3 _220 = _147 + ((((_182 * parameters.gTaps[0].x) + (_194 * parameters.gTaps[0].y)) + (_203 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _215)));
    float _221 = 1.0 / parameters.gRadius;
    float _223 = _220.z;
    vec2 _225 = _220.xy * (1.0 / _223);
    vec4 _232 = textureLod(gInCoarseDepth, _225, 0.0);
    float _233 = _232.x;
    float _237 = _223 - ((_233 > 0.0) ? min(_233, 65504.0) : 65504.0);
    vec2 _244 = vec2(clamp(_237 * _139 + (-1.0), 0.0, 1.0) * clamp((-_237) * _221 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _245 = bvec2((_223 > 0.0) && all(lessThanEqual(floatBitsToUint(_225), uvec2(1065353216u))));
    vec3 _262 = _147 + ((((_182 * parameters.gTaps[1].x) + (_194 * parameters.gTaps[1].y)) + (_203 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _215)));
    float _264 = _262.z;
    vec2 _266 = _262.xy * (1.0 / _264);
    vec4 _273 = textureLod(gInCoarseDepth, _266, 0.0);
    float _274 = _273.x;
    float _278 = _264 - ((_274 > 0.0) ? min(_274, 65504.0) : 65504.0);
    vec2 _285 = vec2(clamp(_278 * _139 + (-1.0), 0.0, 1.0) * clamp((-_278) * _221 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _286 = bvec2((_264 > 0.0) && all(lessThanEqual(floatBitsToUint(_266), uvec2(1065353216u))));
    vec3 _304 = _147 + ((((_182 * parameters.gTaps[2].x) + (_194 * parameters.gTaps[2].y)) + (_203 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _215)));
    float _306 = _304.z;
    vec2 _308 = _304.xy * (1.0 / _306);
    vec4 _315 = textureLod(gInCoarseDepth, _308, 0.0);
    float _316 = _315.x;
    float _320 = _306 - ((_316 > 0.0) ? min(_316, 65504.0) : 65504.0);
    vec2 _327 = vec2(clamp(_320 * _139 + (-1.0), 0.0, 1.0) * clamp((-_320) * _221 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _328 = bvec2((_306 > 0.0) && all(lessThanEqual(floatBitsToUint(_308), uvec2(1065353216u))));
    vec3 _346 = _147 + ((((_182 * parameters.gTaps[3].x) + (_194 * parameters.gTaps[3].y)) + (_203 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _215)));
    float _348 = _346.z;
    vec2 _350 = _346.xy * (1.0 / _348);
    vec4 _357 = textureLod(gInCoarseDepth, _350, 0.0);
    float _358 = _357.x;
    float _362 = _348 - ((_358 > 0.0) ? min(_358, 65504.0) : 65504.0);
    vec2 _369 = vec2(clamp(_362 * _139 + (-1.0), 0.0, 1.0) * clamp((-_362) * _221 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _370 = bvec2((_348 > 0.0) && all(lessThanEqual(floatBitsToUint(_350), uvec2(1065353216u))));
    vec2 _372 = ((vec2(_245.x ? _244.x : vec2(0.0).x, _245.y ? _244.y : vec2(0.0).y) + vec2(_286.x ? _285.x : vec2(0.0).x, _286.y ? _285.y : vec2(0.0).y)) + vec2(_328.x ? _327.x : vec2(0.0).x, _328.y ? _327.y : vec2(0.0).y)) + vec2(_370.x ? _369.x : vec2(0.0).x, _370.y ? _369.y : vec2(0.0).y);
    gOutOcclusion = vec4((_78 < 65504.0) ? (1.0 - (_372.x / max(_372.y, 1.0))) : 1.0, _78, 0.0, 0.0);
}

