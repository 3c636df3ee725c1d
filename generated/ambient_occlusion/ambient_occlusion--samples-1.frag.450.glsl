#version 450

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    float gRadius;
    float gFrameIndex;
    float gSubsetCount;
    vec2 gBias;
    vec2 gFrameToCoarse;
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _72 = parameters.gOutputSize.zw * 0.5;
    vec4 _75 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_72));
    vec4 _78 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _72));
    float _79 = _75.y;
    float _81 = (_79 > 0.0) ? _79 : 65504.0;
    float _83 = (_81 < 65504.0) ? _81 : 65504.0;
    float _84 = _75.x;
    float _86 = (_84 > 0.0) ? _84 : 65504.0;
    float _88 = (_86 < 65504.0) ? _86 : 65504.0;
    float _89 = _75.z;
    float _91 = (_89 > 0.0) ? _89 : 65504.0;
    float _93 = (_91 < 65504.0) ? _91 : 65504.0;
    float _94 = _78.z;
    float _96 = (_94 > 0.0) ? _94 : 65504.0;
    float _98 = (_96 < 65504.0) ? _96 : 65504.0;
    float _99 = _78.x;
    float _101 = (_99 > 0.0) ? _99 : 65504.0;
    float _103 = (_101 < 65504.0) ? _101 : 65504.0;
    vec3 _112 = vec3(fma(gl_FragCoord.xy * parameters.gOutputSize.zw, parameters.gViewRay.xy, parameters.gViewRay.zw) * _83, _83);
    vec2 _115 = vec2(parameters.gOutputSize.z, 0.0);
    vec2 _117 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_115);
    vec2 _125 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _115);
    vec2 _150 = vec2(0.0, parameters.gOutputSize.w);
    vec2 _152 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_150);
    vec2 _160 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _150);
    vec3 _183 = cross(mix(vec3(fma(_125, parameters.gViewRay.xy, parameters.gViewRay.zw) * _98, _98) - _112, _112 - vec3(fma(_117, parameters.gViewRay.xy, parameters.gViewRay.zw) * _88, _88), bvec3((all(lessThanEqual(abs(_117 - vec2(0.5)), vec2(0.5))) ? abs(_88 - _83) : 131008.0) < (all(lessThanEqual(abs(_125 - vec2(0.5)), vec2(0.5))) ? abs(_98 - _83) : 65504.0))), mix(vec3(fma(_160, parameters.gViewRay.xy, parameters.gViewRay.zw) * _103, _103) - _112, _112 - vec3(fma(_152, parameters.gViewRay.xy, parameters.gViewRay.zw) * _93, _93), bvec3((all(lessThanEqual(abs(_152 - vec2(0.5)), vec2(0.5))) ? abs(_93 - _83) : 131008.0) < (all(lessThanEqual(abs(_160 - vec2(0.5)), vec2(0.5))) ? abs(_103 - _83) : 65504.0))));
    vec3 _193 = normalize(mix(-_183, _183, bvec3((parameters.gViewRay.x * parameters.gViewRay.y) < 0.0)));
    vec2 _194 = floor(gl_FragCoord.xy);
    float _199 = floor(parameters.gSubsetCount);
    float _202 = (_199 > 1.0) ? min(_199, 16.0) : 1.0;
    float _206 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec3 _212 = vec3(0.81917250156402587890625, 0.6710436344146728515625, 0.5497004985809326171875) * fma(-_202, floor((_206 + 0.5) / _202), _206);
    vec2 _215 = floor(_194 * 0.5);
    vec2 _217 = _194 - (_215 * 2.0);
    vec2 _221 = _215 - (floor(_194 * 0.25) * 2.0);
    float _223 = _217.y;
    float _226 = _221.y;
    vec2 _232 = (abs(vec2(_217.x - _223, _221.x - _226)) * 2.0) + vec2(_223, _226);
    float _237 = 6.283185482025146484375 * fma(fma(4.0, _232.x, _232.y), 0.0625, _212.x);
    float _238 = cos(_237);
    float _239 = sin(_237);
    vec2 _244 = vec2(_194.y + 1.0, _194.x);
    vec2 _246 = floor(_244 * 0.5);
    vec2 _248 = _244 - (_246 * 2.0);
    vec2 _252 = _246 - (floor(_244 * 0.25) * 2.0);
    float _254 = _248.y;
    float _257 = _252.y;
    vec2 _263 = (abs(vec2(_248.x - _254, _252.x - _257)) * 2.0) + vec2(_254, _257);
    float _274 = _193.z;
    float _276 = (_274 >= 0.0) ? 1.0 : (-1.0);
    float _278 = (-1.0) / (_276 + _274);
    float _279 = _193.x;
    float _280 = _193.y;
    float _282 = (_279 * _280) * _278;
    vec3 _294 = fract(vec3(0.5));
    float _296 = 6.283185482025146484375 * _294.x;
    float _297 = cos(_296);
    float _298 = sin(_296);
    float _308 = fract(_294.y + _212.y);
    vec2 _310 = vec2(fma(_297, _238, -(_298 * _239)), fma(_297, _239, _298 * _238)) * sqrt(_308);
    vec3 _328 = _112 + ((((vec3(fma((_276 * _279) * _279, _278, 1.0), _276 * _282, (-_276) * _279) * _310.x) + (vec3(_282, fma(_280 * _280, _278, _276), -_280) * _310.y)) + (_193 * sqrt(1.0 - _308))) * (parameters.gRadius * sqrt(fract(_294.z + fma(fma(4.0, _263.x, _263.y), 0.0625, _212.z)))));
    float _330 = _328.z;
    vec2 _334 = ((_328.xy / vec2(_330)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _342 = textureLod(gInCoarseDepth, _334, 0.0);
    float _343 = _342.x;
    float _345 = (_343 > 0.0) ? _343 : 65504.0;
    float _348 = _330 - ((_345 < 65504.0) ? _345 : 65504.0);
    vec2 _358 = mix(vec2(0.0), vec2(clamp((_348 / max(fma(parameters.gBias.y, _83, parameters.gBias.x), 9.9999999747524270787835121154785e-07)) - 1.0, 0.0, 1.0) * clamp(2.0 - (_348 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_330 > 0.0) && all(lessThanEqual(abs(_334 - vec2(0.5)), vec2(0.5)))));
    vec2 _367 = mix(vec2(1.0, 65504.0), vec2(1.0 - (_358.x / max(_358.y, 1.0)), _83), bvec2(_83 < 65504.0));
    gOutOcclusion = vec4(_367, 0.0, 0.0);
}

