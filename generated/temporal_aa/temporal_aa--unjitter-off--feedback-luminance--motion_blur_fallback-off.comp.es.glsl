#version 310 es
layout(local_size_x = 16, local_size_y = 4, local_size_z = 1) in;

layout(binding = 0, std140) uniform TemporalAaParameters
{
    vec4 gOutputSize;
    vec2 gJitterPx;
    vec2 gMotionToUv;
    float gHistoryValid;
    float gFeedbackMin;
    float gFeedbackMax;
    float gBlurFromPx;
    float gBlurToPx;
} parameters;

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutHistory;
layout(binding = 2) uniform highp sampler2D gInDepth;
layout(binding = 1) uniform highp sampler2D gInColour;
layout(binding = 3) uniform highp sampler2D gInVelocity;
layout(binding = 4) uniform highp sampler2D gHistoryColour;

void main()
{
    do
    {
        uvec2 _89 = uvec2(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y * 4u);
        uvec2 _93 = uvec2(parameters.gOutputSize.xy);
        bool _95 = any(greaterThanEqual(_89, _93));
        if (_95)
        {
            break;
        }
        vec2 _99 = vec2(_89) + vec2(0.5);
        vec2 _101 = _99 * parameters.gOutputSize.zw;
        vec2 _103 = _99 * parameters.gOutputSize.zw + (vec2(-0.5) * parameters.gOutputSize.zw);
        vec4 _107 = textureGather(gInDepth, _103);
        vec2 _111 = vec2(parameters.gOutputSize.z, 0.0);
        vec4 _113 = textureGather(gInDepth, _103 + _111);
        float _114 = _107.w;
        float _115 = _107.z;
        float _116 = _113.z;
        float _117 = _107.x;
        float _118 = _107.y;
        float _119 = _113.y;
        vec2 _121 = _99 * parameters.gOutputSize.zw + (vec2(-0.5, 1.5) * parameters.gOutputSize.zw);
        vec4 _123 = textureGather(gInDepth, _121);
        vec4 _126 = textureGather(gInDepth, _121 + _111);
        float _127 = _123.w;
        float _128 = _123.z;
        float _129 = _126.z;
        float _130 = _123.x;
        float _131 = _123.y;
        float _132 = _126.y;
        vec2 _134 = _99 * parameters.gOutputSize.zw + (vec2(-0.5, 3.5) * parameters.gOutputSize.zw);
        vec4 _136 = textureGather(gInDepth, _134);
        vec4 _139 = textureGather(gInDepth, _134 + _111);
        float _140 = _136.w;
        float _141 = _136.z;
        float _142 = _139.z;
        float _143 = _136.x;
        float _144 = _136.y;
        float _145 = _139.y;
        vec2 _150 = _99 * parameters.gOutputSize.zw + vec2(0.0, (-1.0) * parameters.gOutputSize.w);
        vec4 _154 = textureLodOffset(gInColour, _150, 0.0, ivec2(-1, 0));
        float _155 = _154.x;
        float _158 = _154.y;
        float _161 = _154.z;
        vec3 _165 = min(vec3((_155 > 0.0) ? _155 : 0.0, (_158 > 0.0) ? _158 : 0.0, (_161 > 0.0) ? _161 : 0.0), vec3(65504.0));
        vec4 _167 = textureLod(gInColour, _150, 0.0);
        float _168 = _167.x;
        float _171 = _167.y;
        float _174 = _167.z;
        vec3 _178 = min(vec3((_168 > 0.0) ? _168 : 0.0, (_171 > 0.0) ? _171 : 0.0, (_174 > 0.0) ? _174 : 0.0), vec3(65504.0));
        vec4 _180 = textureLodOffset(gInColour, _150, 0.0, ivec2(1, 0));
        float _181 = _180.x;
        float _184 = _180.y;
        float _187 = _180.z;
        vec3 _191 = min(vec3((_181 > 0.0) ? _181 : 0.0, (_184 > 0.0) ? _184 : 0.0, (_187 > 0.0) ? _187 : 0.0), vec3(65504.0));
        vec4 _193 = textureLodOffset(gInColour, _101, 0.0, ivec2(-1, 0));
        float _194 = _193.x;
        float _197 = _193.y;
        float _200 = _193.z;
        vec3 _204 = min(vec3((_194 > 0.0) ? _194 : 0.0, (_197 > 0.0) ? _197 : 0.0, (_200 > 0.0) ? _200 : 0.0), vec3(65504.0));
        vec4 _206 = textureLod(gInColour, _101, 0.0);
        float _207 = _206.x;
        float _210 = _206.y;
        float _213 = _206.z;
        vec3 _217 = min(vec3((_207 > 0.0) ? _207 : 0.0, (_210 > 0.0) ? _210 : 0.0, (_213 > 0.0) ? _213 : 0.0), vec3(65504.0));
        vec4 _219 = textureLodOffset(gInColour, _101, 0.0, ivec2(1, 0));
        float _220 = _219.x;
        float _223 = _219.y;
        float _226 = _219.z;
        vec3 _230 = min(vec3((_220 > 0.0) ? _220 : 0.0, (_223 > 0.0) ? _223 : 0.0, (_226 > 0.0) ? _226 : 0.0), vec3(65504.0));
        vec2 _232 = _99 * parameters.gOutputSize.zw + vec2(0.0, parameters.gOutputSize.w);
        vec4 _234 = textureLodOffset(gInColour, _232, 0.0, ivec2(-1, 0));
        float _235 = _234.x;
        float _238 = _234.y;
        float _241 = _234.z;
        vec3 _245 = min(vec3((_235 > 0.0) ? _235 : 0.0, (_238 > 0.0) ? _238 : 0.0, (_241 > 0.0) ? _241 : 0.0), vec3(65504.0));
        vec4 _247 = textureLod(gInColour, _232, 0.0);
        float _248 = _247.x;
        float _251 = _247.y;
        float _254 = _247.z;
        vec3 _258 = min(vec3((_248 > 0.0) ? _248 : 0.0, (_251 > 0.0) ? _251 : 0.0, (_254 > 0.0) ? _254 : 0.0), vec3(65504.0));
        vec4 _260 = textureLodOffset(gInColour, _232, 0.0, ivec2(1, 0));
        float _261 = _260.x;
        float _264 = _260.y;
        float _267 = _260.z;
        vec3 _271 = min(vec3((_261 > 0.0) ? _261 : 0.0, (_264 > 0.0) ? _264 : 0.0, (_267 > 0.0) ? _267 : 0.0), vec3(65504.0));
        vec2 _274 = _99 * parameters.gOutputSize.zw + vec2(0.0, 2.0 * parameters.gOutputSize.w);
        vec4 _276 = textureLodOffset(gInColour, _274, 0.0, ivec2(-1, 0));
        float _277 = _276.x;
        float _280 = _276.y;
        float _283 = _276.z;
        vec3 _287 = min(vec3((_277 > 0.0) ? _277 : 0.0, (_280 > 0.0) ? _280 : 0.0, (_283 > 0.0) ? _283 : 0.0), vec3(65504.0));
        vec4 _289 = textureLod(gInColour, _274, 0.0);
        float _290 = _289.x;
        float _293 = _289.y;
        float _296 = _289.z;
        vec3 _300 = min(vec3((_290 > 0.0) ? _290 : 0.0, (_293 > 0.0) ? _293 : 0.0, (_296 > 0.0) ? _296 : 0.0), vec3(65504.0));
        vec4 _302 = textureLodOffset(gInColour, _274, 0.0, ivec2(1, 0));
        float _303 = _302.x;
        float _306 = _302.y;
        float _309 = _302.z;
        vec3 _313 = min(vec3((_303 > 0.0) ? _303 : 0.0, (_306 > 0.0) ? _306 : 0.0, (_309 > 0.0) ? _309 : 0.0), vec3(65504.0));
        vec2 _316 = _99 * parameters.gOutputSize.zw + vec2(0.0, 3.0 * parameters.gOutputSize.w);
        vec4 _318 = textureLodOffset(gInColour, _316, 0.0, ivec2(-1, 0));
        float _319 = _318.x;
        float _322 = _318.y;
        float _325 = _318.z;
        vec3 _329 = min(vec3((_319 > 0.0) ? _319 : 0.0, (_322 > 0.0) ? _322 : 0.0, (_325 > 0.0) ? _325 : 0.0), vec3(65504.0));
        vec4 _331 = textureLod(gInColour, _316, 0.0);
        float _332 = _331.x;
        float _335 = _331.y;
        float _338 = _331.z;
        vec3 _342 = min(vec3((_332 > 0.0) ? _332 : 0.0, (_335 > 0.0) ? _335 : 0.0, (_338 > 0.0) ? _338 : 0.0), vec3(65504.0));
        vec4 _344 = textureLodOffset(gInColour, _316, 0.0, ivec2(1, 0));
        float _345 = _344.x;
        float _348 = _344.y;
        float _351 = _344.z;
        vec3 _355 = min(vec3((_345 > 0.0) ? _345 : 0.0, (_348 > 0.0) ? _348 : 0.0, (_351 > 0.0) ? _351 : 0.0), vec3(65504.0));
        vec2 _358 = _99 * parameters.gOutputSize.zw + vec2(0.0, 4.0 * parameters.gOutputSize.w);
        vec4 _360 = textureLodOffset(gInColour, _358, 0.0, ivec2(-1, 0));
        float _361 = _360.x;
        float _364 = _360.y;
        float _367 = _360.z;
        vec3 _371 = min(vec3((_361 > 0.0) ? _361 : 0.0, (_364 > 0.0) ? _364 : 0.0, (_367 > 0.0) ? _367 : 0.0), vec3(65504.0));
        vec4 _373 = textureLod(gInColour, _358, 0.0);
        float _374 = _373.x;
        float _377 = _373.y;
        float _380 = _373.z;
        vec3 _384 = min(vec3((_374 > 0.0) ? _374 : 0.0, (_377 > 0.0) ? _377 : 0.0, (_380 > 0.0) ? _380 : 0.0), vec3(65504.0));
        vec4 _386 = textureLodOffset(gInColour, _358, 0.0, ivec2(1, 0));
        float _387 = _386.x;
        float _390 = _386.y;
        float _393 = _386.z;
        vec3 _397 = min(vec3((_387 > 0.0) ? _387 : 0.0, (_390 > 0.0) ? _390 : 0.0, (_393 > 0.0) ? _393 : 0.0), vec3(65504.0));
        vec2 _402 = mix(vec2(_117, -1.0), vec2(_119, 1.0), bvec2(_119 < _117));
        vec2 _407 = mix(vec2(_118, 0.0), _402, bvec2(_402.x < _118));
        vec2 _412 = mix(vec2(_114, -1.0), vec2(_116, 1.0), bvec2(_116 < _114));
        vec2 _417 = mix(vec2(_115, 0.0), _412, bvec2(_412.x < _115));
        vec2 _422 = mix(vec2(_127, -1.0), vec2(_129, 1.0), bvec2(_129 < _127));
        vec2 _427 = mix(vec2(_128, 0.0), _422, bvec2(_422.x < _128));
        float _428 = _427.x;
        bool _430 = _428 < _417.x;
        vec2 _432 = mix(_417, _427, bvec2(_430));
        float _435 = _407.x;
        vec3 _453 = min(_204, _230);
        vec3 _456 = min(min(_453, _217), min(_178, _258));
        vec3 _457 = max(_204, _230);
        vec3 _460 = max(max(_457, _217), max(_178, _258));
        vec3 _462 = min(_245, _271);
        vec3 _466 = max(_245, _271);
        vec3 _470 = (_456 + min(_456, min(min(_165, _191), _462))) * 0.5;
        vec3 _472 = (_460 + max(_460, max(max(_165, _191), _466))) * 0.5;
        vec2 _474 = _99 * parameters.gOutputSize.zw + (-(textureLod(gInVelocity, _99 * parameters.gOutputSize.zw + (mix(vec2(_407.y, 0.0), vec2(_432.y, _430 ? 1.0 : (-1.0)), bvec2(_432.x < _435)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
        vec4 _478 = textureLod(gHistoryColour, _474, 0.0);
        float _479 = _478.x;
        float _482 = _478.y;
        float _485 = _478.z;
        vec3 _491 = (_472 + _470) * 0.5;
        vec3 _495 = min(vec3((_479 > 0.0) ? _479 : 0.0, (_482 > 0.0) ? _482 : 0.0, (_485 > 0.0) ? _485 : 0.0), vec3(65504.0)) - _491;
        vec3 _498 = max((_472 - _470) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_495) + vec3(1.0000000031710768509710513471353e-30));
        vec3 _506 = _491 + (_495 * min(min(_498.x, 1.0), min(_498.y, _498.z)));
        float _507 = dot(_217, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
        float _508 = dot(_506, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
        float _518 = 1.0 - (abs(_507 - _508) / max(max(_507, _508), 0.20000000298023223876953125));
        do
        {
            if (_95)
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_89), vec4(min(_217 + ((_506 - _217) * (all(lessThanEqual(abs(_474 - vec2(0.5)), vec2(0.5))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _518 * _518) * parameters.gHistoryValid) : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _546 = mix(vec2(_130, -1.0), vec2(_132, 1.0), bvec2(_132 < _130));
        vec2 _551 = mix(vec2(_131, 0.0), _546, bvec2(_546.x < _131));
        float _552 = _551.x;
        bool _553 = _552 < _435;
        vec2 _555 = mix(_407, _551, bvec2(_553));
        vec3 _571 = min(min(_462, _258), min(_217, _300));
        vec3 _574 = max(max(_466, _258), max(_217, _300));
        vec3 _575 = min(_287, _313);
        vec3 _578 = max(_287, _313);
        vec3 _582 = (_571 + min(_571, min(_453, _575))) * 0.5;
        vec3 _584 = (_574 + max(_574, max(_457, _578))) * 0.5;
        vec2 _586 = (-textureLod(gInVelocity, mix(vec2(_427.y, 0.0), vec2(_555.y, _553 ? 1.0 : (-1.0)), bvec2(_555.x < _428)) * parameters.gOutputSize.zw + _232, 0.0).xy) * parameters.gMotionToUv + _232;
        vec4 _588 = textureLod(gHistoryColour, _586, 0.0);
        float _589 = _588.x;
        float _592 = _588.y;
        float _595 = _588.z;
        vec3 _601 = (_584 + _582) * 0.5;
        vec3 _605 = min(vec3((_589 > 0.0) ? _589 : 0.0, (_592 > 0.0) ? _592 : 0.0, (_595 > 0.0) ? _595 : 0.0), vec3(65504.0)) - _601;
        vec3 _608 = max((_584 - _582) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_605) + vec3(1.0000000031710768509710513471353e-30));
        vec3 _616 = _601 + (_605 * min(min(_608.x, 1.0), min(_608.y, _608.z)));
        float _617 = dot(_258, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
        float _618 = dot(_616, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
        float _624 = 1.0 - (abs(_617 - _618) / max(max(_617, _618), 0.20000000298023223876953125));
        uvec2 _637 = _89 + uvec2(0u, 1u);
        do
        {
            if (any(greaterThanEqual(_637, _93)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_637), vec4(min(_258 + ((_616 - _258) * (all(lessThanEqual(abs(_586 - vec2(0.5)), vec2(0.5))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _624 * _624) * parameters.gHistoryValid) : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _653 = mix(vec2(_140, -1.0), vec2(_142, 1.0), bvec2(_142 < _140));
        vec2 _658 = mix(vec2(_141, 0.0), _653, bvec2(_653.x < _141));
        float _659 = _658.x;
        bool _660 = _659 < _428;
        vec2 _662 = mix(_427, _658, bvec2(_660));
        vec3 _678 = min(min(_575, _300), min(_258, _342));
        vec3 _681 = max(max(_578, _300), max(_258, _342));
        vec3 _682 = min(_329, _355);
        vec3 _685 = max(_329, _355);
        vec3 _689 = (_678 + min(_678, min(_462, _682))) * 0.5;
        vec3 _691 = (_681 + max(_681, max(_466, _685))) * 0.5;
        vec2 _693 = (-textureLod(gInVelocity, mix(vec2(_551.y, 0.0), vec2(_662.y, _660 ? 1.0 : (-1.0)), bvec2(_662.x < _552)) * parameters.gOutputSize.zw + _274, 0.0).xy) * parameters.gMotionToUv + _274;
        vec4 _695 = textureLod(gHistoryColour, _693, 0.0);
        float _696 = _695.x;
        float _699 = _695.y;
        float _702 = _695.z;
        vec3 _708 = (_691 + _689) * 0.5;
        vec3 _712 = min(vec3((_696 > 0.0) ? _696 : 0.0, (_699 > 0.0) ? _699 : 0.0, (_702 > 0.0) ? _702 : 0.0), vec3(65504.0)) - _708;
        vec3 _715 = max((_691 - _689) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_712) + vec3(1.0000000031710768509710513471353e-30));
        vec3 _723 = _708 + (_712 * min(min(_715.x, 1.0), min(_715.y, _715.z)));
        float _724 = dot(_300, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
        float _725 = dot(_723, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
        float _731 = 1.0 - (abs(_724 - _725) / max(max(_724, _725), 0.20000000298023223876953125));
        uvec2 _744 = _89 + uvec2(0u, 2u);
        do
        {
            if (any(greaterThanEqual(_744, _93)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_744), vec4(min(_300 + ((_723 - _300) * (all(lessThanEqual(abs(_693 - vec2(0.5)), vec2(0.5))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _731 * _731) * parameters.gHistoryValid) : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _760 = mix(vec2(_143, -1.0), vec2(_145, 1.0), bvec2(_145 < _143));
        vec2 _765 = mix(vec2(_144, 0.0), _760, bvec2(_760.x < _144));
        bool _767 = _765.x < _552;
        vec2 _769 = mix(_551, _765, bvec2(_767));
        vec3 _785 = min(min(_682, _342), min(_300, _384));
        vec3 _788 = max(max(_685, _342), max(_300, _384));
        vec3 _796 = (_785 + min(_785, min(_575, min(_371, _397)))) * 0.5;
        vec3 _798 = (_788 + max(_788, max(_578, max(_371, _397)))) * 0.5;
        vec2 _800 = (-textureLod(gInVelocity, mix(vec2(_658.y, 0.0), vec2(_769.y, _767 ? 1.0 : (-1.0)), bvec2(_769.x < _659)) * parameters.gOutputSize.zw + _316, 0.0).xy) * parameters.gMotionToUv + _316;
        vec4 _802 = textureLod(gHistoryColour, _800, 0.0);
        float _803 = _802.x;
        float _806 = _802.y;
        float _809 = _802.z;
        vec3 _815 = (_798 + _796) * 0.5;
        vec3 _819 = min(vec3((_803 > 0.0) ? _803 : 0.0, (_806 > 0.0) ? _806 : 0.0, (_809 > 0.0) ? _809 : 0.0), vec3(65504.0)) - _815;
        vec3 _822 = max((_798 - _796) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_819) + vec3(1.0000000031710768509710513471353e-30));
        vec3 _830 = _815 + (_819 * min(min(_822.x, 1.0), min(_822.y, _822.z)));
        float _831 = dot(_342, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
        float _832 = dot(_830, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
        float _838 = 1.0 - (abs(_831 - _832) / max(max(_831, _832), 0.20000000298023223876953125));
        uvec2 _851 = _89 + uvec2(0u, 3u);
        do
        {
            if (any(greaterThanEqual(_851, _93)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_851), vec4(min(_342 + ((_830 - _342) * (all(lessThanEqual(abs(_800 - vec2(0.5)), vec2(0.5))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _838 * _838) * parameters.gHistoryValid) : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        break;
    } while(false);
}

