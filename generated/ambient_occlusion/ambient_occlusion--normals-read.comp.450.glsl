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
    vec2 gFrameToCoarse;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutOcclusion;
layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInNormal;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _95 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _97 = _95 * parameters.gOutputSize.zw;
        vec4 _101 = textureLod(gInCoarseDepth, _97, 0.0);
        float _102 = _101.x;
        float _104 = (_102 > 0.0) ? _102 : 65504.0;
        float _106 = (_104 < 65504.0) ? _104 : 65504.0;
        vec3 _115 = vec3(fma(_97, parameters.gViewRay.xy, parameters.gViewRay.zw) * _106, _106);
        vec3 _126 = textureLod(gInNormal, fma(_95, parameters.gOutputSize.zw, -(parameters.gOutputSize.zw * 0.125)) / parameters.gFrameToCoarse, 0.0).xyz;
        float _127 = dot(_126, _126);
        vec3 _134 = mix(vec3(0.0, 0.0, -1.0), _126 * inversesqrt(_127), bvec3((_127 > 9.9999999747524270787835121154785e-07) && (_127 < 1000000.0)));
        vec2 _135 = floor(_95);
        float _140 = floor(parameters.gSubsetCount);
        float _143 = (_140 > 1.0) ? min(_140, 16.0) : 1.0;
        float _147 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec3 _153 = vec3(0.276690065860748291015625, 0.68417441844940185546875, 0.1988019049167633056640625) * fma(-_143, floor((_147 + 0.5) / _143), _147);
        vec2 _156 = floor(_135 * 0.5);
        vec2 _158 = _135 - (_156 * 2.0);
        vec2 _162 = _156 - (floor(_135 * 0.25) * 2.0);
        float _164 = _158.y;
        float _167 = _162.y;
        vec2 _173 = (abs(vec2(_158.x - _164, _162.x - _167)) * 2.0) + vec2(_164, _167);
        float _178 = 6.283185482025146484375 * fma(fma(4.0, _173.x, _173.y), 0.0625, _153.x);
        float _179 = cos(_178);
        float _180 = sin(_178);
        vec2 _185 = vec2(_135.y + 1.0, _135.x);
        vec2 _187 = floor(_185 * 0.5);
        vec2 _189 = _185 - (_187 * 2.0);
        vec2 _193 = _187 - (floor(_185 * 0.25) * 2.0);
        float _195 = _189.y;
        float _198 = _193.y;
        vec2 _204 = (abs(vec2(_189.x - _195, _193.x - _198)) * 2.0) + vec2(_195, _198);
        float _208 = fma(fma(4.0, _204.x, _204.y), 0.0625, _153.z);
        float _214 = max(fma(parameters.gBias.y, _106, parameters.gBias.x), 9.9999999747524270787835121154785e-07);
        float _215 = _134.z;
        float _217 = (_215 >= 0.0) ? 1.0 : (-1.0);
        float _219 = (-1.0) / (_217 + _215);
        float _220 = _134.x;
        float _221 = _134.y;
        float _223 = (_220 * _221) * _219;
        vec3 _230 = vec3(fma((_217 * _220) * _220, _219, 1.0), _217 * _223, (-_217) * _220);
        vec3 _234 = vec3(_223, fma(_221 * _221, _219, _217), -_221);
        vec3 _235 = fract(vec3(0.5));
        float _237 = 6.283185482025146484375 * _235.x;
        float _238 = cos(_237);
        float _239 = sin(_237);
        float _247 = _153.y;
        float _249 = fract(_235.y + _247);
        vec2 _251 = vec2(fma(_238, _179, -(_239 * _180)), fma(_238, _180, _239 * _179)) * sqrt(_249);
        vec3 _269 = _115 + ((((_230 * _251.x) + (_234 * _251.y)) + (_134 * sqrt(1.0 - _249))) * (parameters.gRadius * sqrt(fract(_235.z + _208))));
        float _271 = _269.z;
        vec2 _275 = ((_269.xy / vec2(_271)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _283 = textureLod(gInCoarseDepth, _275, 0.0);
        float _284 = _283.x;
        float _286 = (_284 > 0.0) ? _284 : 65504.0;
        float _289 = _271 - ((_286 < 65504.0) ? _286 : 65504.0);
        vec3 _300 = fract(vec3(1.31917250156402587890625, 1.1710436344146728515625, 1.0497004985809326171875));
        float _302 = 6.283185482025146484375 * _300.x;
        float _303 = cos(_302);
        float _304 = sin(_302);
        float _313 = fract(_300.y + _247);
        vec2 _315 = vec2(fma(_303, _179, -(_304 * _180)), fma(_303, _180, _304 * _179)) * sqrt(_313);
        vec3 _331 = _115 + ((((_230 * _315.x) + (_234 * _315.y)) + (_134 * sqrt(1.0 - _313))) * (parameters.gRadius * sqrt(fract(_300.z + _208))));
        float _333 = _331.z;
        vec2 _337 = ((_331.xy / vec2(_333)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _345 = textureLod(gInCoarseDepth, _337, 0.0);
        float _346 = _345.x;
        float _348 = (_346 > 0.0) ? _346 : 65504.0;
        float _351 = _333 - ((_348 < 65504.0) ? _348 : 65504.0);
        vec3 _363 = fract(vec3(2.1383450031280517578125, 1.842087268829345703125, 1.599400997161865234375));
        float _365 = 6.283185482025146484375 * _363.x;
        float _366 = cos(_365);
        float _367 = sin(_365);
        float _376 = fract(_363.y + _247);
        vec2 _378 = vec2(fma(_366, _179, -(_367 * _180)), fma(_366, _180, _367 * _179)) * sqrt(_376);
        vec3 _394 = _115 + ((((_230 * _378.x) + (_234 * _378.y)) + (_134 * sqrt(1.0 - _376))) * (parameters.gRadius * sqrt(fract(_363.z + _208))));
        float _396 = _394.z;
        vec2 _400 = ((_394.xy / vec2(_396)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _408 = textureLod(gInCoarseDepth, _400, 0.0);
        float _409 = _408.x;
        float _411 = (_409 > 0.0) ? _409 : 65504.0;
        float _414 = _396 - ((_411 < 65504.0) ? _411 : 65504.0);
        vec3 _426 = fract(vec3(2.9575176239013671875, 2.5131309032440185546875, 2.1491014957427978515625));
        float _428 = 6.283185482025146484375 * _426.x;
        float _429 = cos(_428);
        float _430 = sin(_428);
        float _439 = fract(_426.y + _247);
        vec2 _441 = vec2(fma(_429, _179, -(_430 * _180)), fma(_429, _180, _430 * _179)) * sqrt(_439);
        vec3 _457 = _115 + ((((_230 * _441.x) + (_234 * _441.y)) + (_134 * sqrt(1.0 - _439))) * (parameters.gRadius * sqrt(fract(_426.z + _208))));
        float _459 = _457.z;
        vec2 _463 = ((_457.xy / vec2(_459)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
        vec4 _471 = textureLod(gInCoarseDepth, _463, 0.0);
        float _472 = _471.x;
        float _474 = (_472 > 0.0) ? _472 : 65504.0;
        float _477 = _459 - ((_474 < 65504.0) ? _474 : 65504.0);
        vec2 _488 = ((mix(vec2(0.0), vec2(clamp((_289 / _214) - 1.0, 0.0, 1.0) * clamp(2.0 - (_289 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_271 > 0.0) && all(lessThanEqual(abs(_275 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp((_351 / _214) - 1.0, 0.0, 1.0) * clamp(2.0 - (_351 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_333 > 0.0) && all(lessThanEqual(abs(_337 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_414 / _214) - 1.0, 0.0, 1.0) * clamp(2.0 - (_414 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_396 > 0.0) && all(lessThanEqual(abs(_400 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_477 / _214) - 1.0, 0.0, 1.0) * clamp(2.0 - (_477 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_459 > 0.0) && all(lessThanEqual(abs(_463 - vec2(0.5)), vec2(0.5)))));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4(mix(vec2(1.0, 65504.0), vec2(1.0 - (_488.x / max(_488.y, 1.0)), _106), bvec2(_106 < 65504.0)), 0.0, 0.0));
        break;
    } while(false);
}

