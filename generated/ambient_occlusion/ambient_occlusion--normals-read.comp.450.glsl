#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    float gRadius;
    float gFrameIndex;
    float gSubsetCount;
    vec2 gBias;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutOcclusion;
layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInCoarseNormal;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _92 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _94 = _92 * parameters.gOutputSize.zw;
        vec4 _98 = textureLod(gInCoarseDepth, _94, 0.0);
        float _99 = _98.x;
        float _101 = (_99 > 0.0) ? _99 : 65504.0;
        float _103 = (_101 < 65504.0) ? _101 : 65504.0;
        vec3 _112 = vec3(fma(_94, parameters.gViewRay.xy, parameters.gViewRay.zw) * _103, _103);
        vec3 _117 = textureLod(gInCoarseNormal, _94, 0.0).xyz;
        float _118 = dot(_117, _117);
        vec3 _125 = mix(vec3(0.0, 0.0, -1.0), _117 * inversesqrt(_118), bvec3((_118 > 9.9999999747524270787835121154785e-07) && (_118 < 1000000.0)));
        vec2 _126 = floor(_92);
        float _131 = floor(parameters.gSubsetCount);
        float _134 = (_131 > 1.0) ? min(_131, 16.0) : 1.0;
        float _138 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec3 _144 = vec3(0.276690065860748291015625, 0.68417441844940185546875, 0.1988019049167633056640625) * fma(-_134, floor((_138 + 0.5) / _134), _138);
        vec2 _147 = floor(_126 * 0.5);
        vec2 _149 = _126 - (_147 * 2.0);
        vec2 _153 = _147 - (floor(_126 * 0.25) * 2.0);
        float _155 = _149.y;
        float _158 = _153.y;
        vec2 _164 = (abs(vec2(_149.x - _155, _153.x - _158)) * 2.0) + vec2(_155, _158);
        float _169 = 6.283185482025146484375 * fma(fma(4.0, _164.x, _164.y), 0.0625, _144.x);
        float _170 = cos(_169);
        float _171 = sin(_169);
        vec2 _176 = vec2(_126.y + 1.0, _126.x);
        vec2 _178 = floor(_176 * 0.5);
        vec2 _180 = _176 - (_178 * 2.0);
        vec2 _184 = _178 - (floor(_176 * 0.25) * 2.0);
        float _186 = _180.y;
        float _189 = _184.y;
        vec2 _195 = (abs(vec2(_180.x - _186, _184.x - _189)) * 2.0) + vec2(_186, _189);
        float _199 = fma(fma(4.0, _195.x, _195.y), 0.0625, _144.z);
        float _205 = max(fma(parameters.gBias.y, _103, parameters.gBias.x), 9.9999999747524270787835121154785e-07);
        float _206 = _125.z;
        float _208 = (_206 >= 0.0) ? 1.0 : (-1.0);
        float _210 = (-1.0) / (_208 + _206);
        float _211 = _125.x;
        float _212 = _125.y;
        float _214 = (_211 * _212) * _210;
        vec3 _221 = vec3(fma((_208 * _211) * _211, _210, 1.0), _208 * _214, (-_208) * _211);
        vec3 _225 = vec3(_214, fma(_212 * _212, _210, _208), -_212);
        vec3 _226 = fract(vec3(0.5));
        float _228 = 6.283185482025146484375 * _226.x;
        float _229 = cos(_228);
        float _230 = sin(_228);
        float _238 = _144.y;
        float _240 = fract(_226.y + _238);
        vec2 _242 = vec2(fma(_229, _170, -(_230 * _171)), fma(_229, _171, _230 * _170)) * sqrt(_240);
        vec3 _260 = _112 + ((((_221 * _242.x) + (_225 * _242.y)) + (_125 * sqrt(1.0 - _240))) * (parameters.gRadius * sqrt(fract(_226.z + _199))));
        float _262 = _260.z;
        vec2 _266 = ((_260.xy / vec2(_262)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _274 = textureLod(gInCoarseDepth, _266, 0.0);
        float _275 = _274.x;
        float _277 = (_275 > 0.0) ? _275 : 65504.0;
        float _280 = _262 - ((_277 < 65504.0) ? _277 : 65504.0);
        vec3 _291 = fract(vec3(1.31917250156402587890625, 1.1710436344146728515625, 1.0497004985809326171875));
        float _293 = 6.283185482025146484375 * _291.x;
        float _294 = cos(_293);
        float _295 = sin(_293);
        float _304 = fract(_291.y + _238);
        vec2 _306 = vec2(fma(_294, _170, -(_295 * _171)), fma(_294, _171, _295 * _170)) * sqrt(_304);
        vec3 _322 = _112 + ((((_221 * _306.x) + (_225 * _306.y)) + (_125 * sqrt(1.0 - _304))) * (parameters.gRadius * sqrt(fract(_291.z + _199))));
        float _324 = _322.z;
        vec2 _328 = ((_322.xy / vec2(_324)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _336 = textureLod(gInCoarseDepth, _328, 0.0);
        float _337 = _336.x;
        float _339 = (_337 > 0.0) ? _337 : 65504.0;
        float _342 = _324 - ((_339 < 65504.0) ? _339 : 65504.0);
        vec3 _354 = fract(vec3(2.1383450031280517578125, 1.842087268829345703125, 1.599400997161865234375));
        float _356 = 6.283185482025146484375 * _354.x;
        float _357 = cos(_356);
        float _358 = sin(_356);
        float _367 = fract(_354.y + _238);
        vec2 _369 = vec2(fma(_357, _170, -(_358 * _171)), fma(_357, _171, _358 * _170)) * sqrt(_367);
        vec3 _385 = _112 + ((((_221 * _369.x) + (_225 * _369.y)) + (_125 * sqrt(1.0 - _367))) * (parameters.gRadius * sqrt(fract(_354.z + _199))));
        float _387 = _385.z;
        vec2 _391 = ((_385.xy / vec2(_387)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _399 = textureLod(gInCoarseDepth, _391, 0.0);
        float _400 = _399.x;
        float _402 = (_400 > 0.0) ? _400 : 65504.0;
        float _405 = _387 - ((_402 < 65504.0) ? _402 : 65504.0);
        vec3 _417 = fract(vec3(2.9575176239013671875, 2.5131309032440185546875, 2.1491014957427978515625));
        float _419 = 6.283185482025146484375 * _417.x;
        float _420 = cos(_419);
        float _421 = sin(_419);
        float _430 = fract(_417.y + _238);
        vec2 _432 = vec2(fma(_420, _170, -(_421 * _171)), fma(_420, _171, _421 * _170)) * sqrt(_430);
        vec3 _448 = _112 + ((((_221 * _432.x) + (_225 * _432.y)) + (_125 * sqrt(1.0 - _430))) * (parameters.gRadius * sqrt(fract(_417.z + _199))));
        float _450 = _448.z;
        vec2 _454 = ((_448.xy / vec2(_450)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _462 = textureLod(gInCoarseDepth, _454, 0.0);
        float _463 = _462.x;
        float _465 = (_463 > 0.0) ? _463 : 65504.0;
        float _468 = _450 - ((_465 < 65504.0) ? _465 : 65504.0);
        vec2 _479 = ((mix(vec2(0.0), vec2(clamp((_280 / _205) - 1.0, 0.0, 1.0) * clamp(2.0 - (_280 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_262 > 0.0) && all(lessThanEqual(abs(_266 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp((_342 / _205) - 1.0, 0.0, 1.0) * clamp(2.0 - (_342 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_324 > 0.0) && all(lessThanEqual(abs(_328 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_405 / _205) - 1.0, 0.0, 1.0) * clamp(2.0 - (_405 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_387 > 0.0) && all(lessThanEqual(abs(_391 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_468 / _205) - 1.0, 0.0, 1.0) * clamp(2.0 - (_468 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_450 > 0.0) && all(lessThanEqual(abs(_454 - vec2(0.5)), vec2(0.5)))));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4(mix(vec2(1.0, 65504.0), vec2(1.0 - (_479.x / max(_479.y, 1.0)), _103), bvec2(_103 < 65504.0)), 0.0, 0.0));
        break;
    } while(false);
}

