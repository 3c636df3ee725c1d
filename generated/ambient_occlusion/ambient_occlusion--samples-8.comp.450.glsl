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
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _75 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _77 = _75 * parameters.gOutputSize.zw;
        vec2 _81 = parameters.gOutputSize.zw * 0.5;
        vec4 _84 = textureGather(gInCoarseDepth, fma(_75, parameters.gOutputSize.zw, -_81));
        vec4 _87 = textureGather(gInCoarseDepth, fma(_75, parameters.gOutputSize.zw, _81));
        float _88 = _84.y;
        float _91 = (_88 > 0.0) ? min(_88, 65504.0) : 65504.0;
        float _92 = _84.x;
        float _95 = (_92 > 0.0) ? min(_92, 65504.0) : 65504.0;
        float _96 = _84.z;
        float _99 = (_96 > 0.0) ? min(_96, 65504.0) : 65504.0;
        float _100 = _87.z;
        float _103 = (_100 > 0.0) ? min(_100, 65504.0) : 65504.0;
        float _104 = _87.x;
        float _107 = (_104 > 0.0) ? min(_104, 65504.0) : 65504.0;
        bvec2 _108 = greaterThan(_77, parameters.gOutputSize.zw);
        bvec2 _110 = lessThan(_77, vec2(1.0) - parameters.gOutputSize.zw);
        float _116 = _103 - _91;
        vec2 _124 = mix(vec2(_116, _103), vec2(_91 - _95, _95), bvec2((_108.x ? abs(_95 - _91) : 131008.0) < (_110.x ? abs(_116) : 65504.0)));
        float _130 = _107 - _91;
        vec2 _138 = mix(vec2(_130, _107), vec2(_91 - _99, _99), bvec2((_108.y ? abs(_99 - _91) : 131008.0) < (_110.y ? abs(_130) : 65504.0)));
        vec2 _150 = vec2(_124.x, _138.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_124.y, _138.y));
        vec3 _158 = normalize(vec3(_150, (-1.0) - dot(fma(_77, parameters.gViewRay.xy, parameters.gViewRay.zw), _150)));
        vec2 _159 = floor(_75);
        vec2 _161 = floor(_159 * 0.5);
        vec2 _163 = _159 - (_161 * 2.0);
        vec2 _167 = _161 - (floor(_161 * 0.5) * 2.0);
        float _168 = _163.x;
        float _169 = _163.y;
        float _171 = abs(_168 - _169);
        float _172 = _167.y;
        float _177 = _167.x;
        vec2 _189 = vec2(fma(2.0, abs(_177 - _172), fma(8.0, _171, 4.0 * _169)) + _172, fma(2.0, abs(abs(_172 - _169) - _177), fma(4.0, _168, fma(-8.0, _171, 8.0))) + _177) * vec2(0.0625);
        float _191 = 6.283185482025146484375 * _189.x;
        float _192 = cos(_191);
        float _193 = sin(_191);
        float _200 = 1.0 / max(fma(parameters.gOcclusionBias.y, _91, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
        vec2 _201 = vec2(1.0) / parameters.gViewRay.xy;
        vec3 _205 = vec3(_77 * _91, _91);
        float _206 = _158.z;
        float _208 = (_206 >= 0.0) ? 1.0 : (-1.0);
        float _210 = (-1.0) / (_208 + _206);
        float _211 = _158.x;
        float _212 = _158.y;
        float _214 = (_211 * _212) * _210;
        vec3 _221 = vec3(fma((_208 * _211) * _211, _210, 1.0), _208 * _214, (-_208) * _211);
        vec3 _225 = vec3(_214, fma(_212 * _212, _210, _208), -_212);
        vec3 _231 = ((_221 * _192) + (_225 * _193)) * parameters.gRadius;
        float _233 = _231.z;
        vec3 _239 = vec3((_231.xy - (parameters.gViewRay.zw * _233)) * _201, _233);
        vec3 _243 = ((_225 * _192) - (_221 * _193)) * parameters.gRadius;
        float _245 = _243.z;
        vec3 _251 = vec3((_243.xy - (parameters.gViewRay.zw * _245)) * _201, _245);
        vec3 _252 = _158 * parameters.gRadius;
        float _254 = _252.z;
        vec3 _260 = vec3((_252.xy - (parameters.gViewRay.zw * _254)) * _201, _254);
        float _272 = _189.y;
        vec3 _277 = _205 + ((((_239 * parameters.gTaps[0].x) + (_251 * parameters.gTaps[0].y)) + (_260 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _272)));
        float _278 = 1.0 / parameters.gRadius;
        float _280 = _277.z;
        vec2 _282 = _277.xy * (1.0 / _280);
        vec4 _290 = textureLod(gInCoarseDepth, _282, 0.0);
        float _291 = _290.x;
        float _295 = _280 - ((_291 > 0.0) ? min(_291, 65504.0) : 65504.0);
        vec3 _320 = _205 + ((((_239 * parameters.gTaps[1].x) + (_251 * parameters.gTaps[1].y)) + (_260 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _272)));
        float _322 = _320.z;
        vec2 _324 = _320.xy * (1.0 / _322);
        vec4 _332 = textureLod(gInCoarseDepth, _324, 0.0);
        float _333 = _332.x;
        float _337 = _322 - ((_333 > 0.0) ? min(_333, 65504.0) : 65504.0);
        vec3 _363 = _205 + ((((_239 * parameters.gTaps[2].x) + (_251 * parameters.gTaps[2].y)) + (_260 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _272)));
        float _365 = _363.z;
        vec2 _367 = _363.xy * (1.0 / _365);
        vec4 _375 = textureLod(gInCoarseDepth, _367, 0.0);
        float _376 = _375.x;
        float _380 = _365 - ((_376 > 0.0) ? min(_376, 65504.0) : 65504.0);
        vec3 _406 = _205 + ((((_239 * parameters.gTaps[3].x) + (_251 * parameters.gTaps[3].y)) + (_260 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _272)));
        float _408 = _406.z;
        vec2 _410 = _406.xy * (1.0 / _408);
        vec4 _418 = textureLod(gInCoarseDepth, _410, 0.0);
        float _419 = _418.x;
        float _423 = _408 - ((_419 > 0.0) ? min(_419, 65504.0) : 65504.0);
        vec3 _449 = _205 + ((((_239 * parameters.gTaps[4].x) + (_251 * parameters.gTaps[4].y)) + (_260 * parameters.gTaps[4].z)) * sqrt(fract(parameters.gTaps[4].w + _272)));
        float _451 = _449.z;
        vec2 _453 = _449.xy * (1.0 / _451);
        vec4 _461 = textureLod(gInCoarseDepth, _453, 0.0);
        float _462 = _461.x;
        float _466 = _451 - ((_462 > 0.0) ? min(_462, 65504.0) : 65504.0);
        vec2 _476 = (((mix(vec2(0.0), vec2(clamp(fma(_295, _200, -1.0), 0.0, 1.0) * clamp(fma(-_295, _278, 2.0), 0.0, 1.0), 1.0), bvec2((_280 > 0.0) && all(lessThanEqual(abs(_282 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_337, _200, -1.0), 0.0, 1.0) * clamp(fma(-_337, _278, 2.0), 0.0, 1.0), 1.0), bvec2((_322 > 0.0) && all(lessThanEqual(abs(_324 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_380, _200, -1.0), 0.0, 1.0) * clamp(fma(-_380, _278, 2.0), 0.0, 1.0), 1.0), bvec2((_365 > 0.0) && all(lessThanEqual(abs(_367 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_423, _200, -1.0), 0.0, 1.0) * clamp(fma(-_423, _278, 2.0), 0.0, 1.0), 1.0), bvec2((_408 > 0.0) && all(lessThanEqual(abs(_410 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_466, _200, -1.0), 0.0, 1.0) * clamp(fma(-_466, _278, 2.0), 0.0, 1.0), 1.0), bvec2((_451 > 0.0) && all(lessThanEqual(abs(_453 - vec2(0.5)), vec2(0.5)))));
        vec3 _492 = _205 + ((((_239 * parameters.gTaps[5].x) + (_251 * parameters.gTaps[5].y)) + (_260 * parameters.gTaps[5].z)) * sqrt(fract(parameters.gTaps[5].w + _272)));
        float _494 = _492.z;
        vec2 _496 = _492.xy * (1.0 / _494);
        vec4 _504 = textureLod(gInCoarseDepth, _496, 0.0);
        float _505 = _504.x;
        float _509 = _494 - ((_505 > 0.0) ? min(_505, 65504.0) : 65504.0);
        vec3 _535 = _205 + ((((_239 * parameters.gTaps[6].x) + (_251 * parameters.gTaps[6].y)) + (_260 * parameters.gTaps[6].z)) * sqrt(fract(parameters.gTaps[6].w + _272)));
        float _537 = _535.z;
        vec2 _539 = _535.xy * (1.0 / _537);
        vec4 _547 = textureLod(gInCoarseDepth, _539, 0.0);
        float _548 = _547.x;
        float _552 = _537 - ((_548 > 0.0) ? min(_548, 65504.0) : 65504.0);
        vec3 _578 = _205 + ((((_239 * parameters.gTaps[7].x) + (_251 * parameters.gTaps[7].y)) + (_260 * parameters.gTaps[7].z)) * sqrt(fract(parameters.gTaps[7].w + _272)));
        float _580 = _578.z;
        vec2 _582 = _578.xy * (1.0 / _580);
        vec4 _590 = textureLod(gInCoarseDepth, _582, 0.0);
        float _591 = _590.x;
        float _595 = _580 - ((_591 > 0.0) ? min(_591, 65504.0) : 65504.0);
        vec2 _605 = ((_476 + mix(vec2(0.0), vec2(clamp(fma(_509, _200, -1.0), 0.0, 1.0) * clamp(fma(-_509, _278, 2.0), 0.0, 1.0), 1.0), bvec2((_494 > 0.0) && all(lessThanEqual(abs(_496 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_552, _200, -1.0), 0.0, 1.0) * clamp(fma(-_552, _278, 2.0), 0.0, 1.0), 1.0), bvec2((_537 > 0.0) && all(lessThanEqual(abs(_539 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_595, _200, -1.0), 0.0, 1.0) * clamp(fma(-_595, _278, 2.0), 0.0, 1.0), 1.0), bvec2((_580 > 0.0) && all(lessThanEqual(abs(_582 - vec2(0.5)), vec2(0.5)))));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_91 < 65504.0) ? (1.0 - (_605.x / max(_605.y, 1.0))) : 1.0, _91, 0.0, 0.0));
        break;
    } while(false);
}

