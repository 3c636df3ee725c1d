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
    vec2 _64 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _68 = parameters.gOutputSize.zw * 0.5;
    vec4 _71 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_68));
    vec4 _74 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _68));
    float _75 = _71.y;
    float _78 = (_75 > 0.0) ? min(_75, 65504.0) : 65504.0;
    float _79 = _71.x;
    float _82 = (_79 > 0.0) ? min(_79, 65504.0) : 65504.0;
    float _83 = _71.z;
    float _86 = (_83 > 0.0) ? min(_83, 65504.0) : 65504.0;
    float _87 = _74.z;
    float _90 = (_87 > 0.0) ? min(_87, 65504.0) : 65504.0;
    float _91 = _74.x;
    float _94 = (_91 > 0.0) ? min(_91, 65504.0) : 65504.0;
    bvec2 _95 = greaterThan(_64, parameters.gOutputSize.zw);
    bvec2 _97 = lessThan(_64, vec2(1.0) - parameters.gOutputSize.zw);
    float _103 = _90 - _78;
    vec2 _111 = mix(vec2(_103, _90), vec2(_78 - _82, _82), bvec2((_95.x ? abs(_82 - _78) : 131008.0) < (_97.x ? abs(_103) : 65504.0)));
    float _117 = _94 - _78;
    vec2 _125 = mix(vec2(_117, _94), vec2(_78 - _86, _86), bvec2((_95.y ? abs(_86 - _78) : 131008.0) < (_97.y ? abs(_117) : 65504.0)));
    vec2 _137 = vec2(_111.x, _125.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_111.y, _125.y));
    vec3 _145 = normalize(vec3(_137, (-1.0) - dot(fma(_64, parameters.gViewRay.xy, parameters.gViewRay.zw), _137)));
    vec2 _146 = floor(gl_FragCoord.xy);
    vec2 _148 = floor(_146 * 0.5);
    vec2 _150 = _146 - (_148 * 2.0);
    vec2 _154 = _148 - (floor(_148 * 0.5) * 2.0);
    float _155 = _150.x;
    float _156 = _150.y;
    float _158 = abs(_155 - _156);
    float _159 = _154.y;
    float _164 = _154.x;
    vec2 _176 = vec2(fma(2.0, abs(_164 - _159), fma(8.0, _158, 4.0 * _156)) + _159, fma(2.0, abs(abs(_159 - _156) - _164), fma(4.0, _155, fma(-8.0, _158, 8.0))) + _164) * vec2(0.0625);
    float _178 = 6.283185482025146484375 * _176.x;
    float _179 = cos(_178);
    float _180 = sin(_178);
    float _187 = 1.0 / max(fma(parameters.gOcclusionBias.y, _78, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _188 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _192 = vec3(_64 * _78, _78);
    float _193 = _145.z;
    float _195 = (_193 >= 0.0) ? 1.0 : (-1.0);
    float _197 = (-1.0) / (_195 + _193);
    float _198 = _145.x;
    float _199 = _145.y;
    float _201 = (_198 * _199) * _197;
    vec3 _208 = vec3(fma((_195 * _198) * _198, _197, 1.0), _195 * _201, (-_195) * _198);
    vec3 _212 = vec3(_201, fma(_199 * _199, _197, _195), -_199);
    vec3 _218 = ((_208 * _179) + (_212 * _180)) * parameters.gRadius;
    float _220 = _218.z;
    vec3 _226 = vec3((_218.xy - (parameters.gViewRay.zw * _220)) * _188, _220);
    vec3 _230 = ((_212 * _179) - (_208 * _180)) * parameters.gRadius;
    float _232 = _230.z;
    vec3 _238 = vec3((_230.xy - (parameters.gViewRay.zw * _232)) * _188, _232);
    vec3 _239 = _145 * parameters.gRadius;
    float _241 = _239.z;
    vec3 _247 = vec3((_239.xy - (parameters.gViewRay.zw * _241)) * _188, _241);
    float _259 = _176.y;
    vec3 _264 = _192 + ((((_226 * parameters.gTaps[0].x) + (_238 * parameters.gTaps[0].y)) + (_247 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _259)));
    float _265 = 1.0 / parameters.gRadius;
    float _267 = _264.z;
    vec2 _269 = _264.xy * (1.0 / _267);
    vec4 _276 = textureLod(gInCoarseDepth, _269, 0.0);
    float _277 = _276.x;
    float _281 = _267 - ((_277 > 0.0) ? min(_277, 65504.0) : 65504.0);
    vec3 _306 = _192 + ((((_226 * parameters.gTaps[1].x) + (_238 * parameters.gTaps[1].y)) + (_247 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _259)));
    float _308 = _306.z;
    vec2 _310 = _306.xy * (1.0 / _308);
    vec4 _317 = textureLod(gInCoarseDepth, _310, 0.0);
    float _318 = _317.x;
    float _322 = _308 - ((_318 > 0.0) ? min(_318, 65504.0) : 65504.0);
    vec3 _348 = _192 + ((((_226 * parameters.gTaps[2].x) + (_238 * parameters.gTaps[2].y)) + (_247 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _259)));
    float _350 = _348.z;
    vec2 _352 = _348.xy * (1.0 / _350);
    vec4 _359 = textureLod(gInCoarseDepth, _352, 0.0);
    float _360 = _359.x;
    float _364 = _350 - ((_360 > 0.0) ? min(_360, 65504.0) : 65504.0);
    vec3 _390 = _192 + ((((_226 * parameters.gTaps[3].x) + (_238 * parameters.gTaps[3].y)) + (_247 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _259)));
    float _392 = _390.z;
    vec2 _394 = _390.xy * (1.0 / _392);
    vec4 _401 = textureLod(gInCoarseDepth, _394, 0.0);
    float _402 = _401.x;
    float _406 = _392 - ((_402 > 0.0) ? min(_402, 65504.0) : 65504.0);
    vec2 _416 = ((mix(vec2(0.0), vec2(clamp(fma(_281, _187, -1.0), 0.0, 1.0) * clamp(fma(-_281, _265, 2.0), 0.0, 1.0), 1.0), bvec2((_267 > 0.0) && all(lessThanEqual(floatBitsToUint(_269), uvec2(1065353216u))))) + mix(vec2(0.0), vec2(clamp(fma(_322, _187, -1.0), 0.0, 1.0) * clamp(fma(-_322, _265, 2.0), 0.0, 1.0), 1.0), bvec2((_308 > 0.0) && all(lessThanEqual(floatBitsToUint(_310), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_364, _187, -1.0), 0.0, 1.0) * clamp(fma(-_364, _265, 2.0), 0.0, 1.0), 1.0), bvec2((_350 > 0.0) && all(lessThanEqual(floatBitsToUint(_352), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_406, _187, -1.0), 0.0, 1.0) * clamp(fma(-_406, _265, 2.0), 0.0, 1.0), 1.0), bvec2((_392 > 0.0) && all(lessThanEqual(floatBitsToUint(_394), uvec2(1065353216u)))));
    gOutOcclusion = vec4((_78 < 65504.0) ? (1.0 - (_416.x / max(_416.y, 1.0))) : 1.0, _78, 0.0, 0.0);
}

