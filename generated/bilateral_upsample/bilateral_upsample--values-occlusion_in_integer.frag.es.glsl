#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

uniform highp sampler2D gInFiltered;
uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _71 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _72 = floor(_71);
    vec2 _73 = _71 - _72;
    vec2 _74 = vec2(1.0) - _73;
    vec2 _75 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _76 = _75 - vec2(1.0);
    vec2 _79 = (clamp(_72, vec2(0.0), _76) + vec2(0.5)) / _75;
    vec2 _83 = (clamp(_72 + vec2(1.0), vec2(0.0), _76) + vec2(0.5)) / _75;
    vec2 _86 = vec2(_83.x, _79.y);
    vec2 _89 = vec2(_79.x, _83.y);
    float _90 = _74.x;
    float _91 = _73.x;
    vec4 _111 = vec4(textureLod(gInFiltered, _79, 0.0).x, textureLod(gInFiltered, _86, 0.0).x, textureLod(gInFiltered, _89, 0.0).x, textureLod(gInFiltered, _83, 0.0).x);
    bvec4 _113 = lessThanEqual(abs(_111), vec4(65504.0));
    vec4 _114 = vec4(_113.x ? _111.x : vec4(1.9999999360571384930131252153835e+38).x, _113.y ? _111.y : vec4(1.9999999360571384930131252153835e+38).y, _113.z ? _111.z : vec4(1.9999999360571384930131252153835e+38).z, _113.w ? _111.w : vec4(1.9999999360571384930131252153835e+38).w);
    float _130 = _114.x;
    float _135 = (_130 > 0.0) ? min(_130, 31.984375) : 0.0;
    float _136 = floor(_135);
    vec2 _141 = min(vec2(_136 * 0.0322580635547637939453125, (_135 - _136) * 1.01587307453155517578125), vec2(1.0));
    vec2 _142 = vec2(_130);
    bvec2 _143 = bvec2(abs(_130) <= 9.9999996802856924650656260769173e+37);
    vec2 _144 = vec2(_143.x ? _141.x : _142.x, _143.y ? _141.y : _142.y);
    float _145 = _114.y;
    float _150 = (_145 > 0.0) ? min(_145, 31.984375) : 0.0;
    float _151 = floor(_150);
    vec2 _156 = min(vec2(_151 * 0.0322580635547637939453125, (_150 - _151) * 1.01587307453155517578125), vec2(1.0));
    vec2 _157 = vec2(_145);
    bvec2 _158 = bvec2(abs(_145) <= 9.9999996802856924650656260769173e+37);
    vec2 _159 = vec2(_158.x ? _156.x : _157.x, _158.y ? _156.y : _157.y);
    float _160 = _114.z;
    float _165 = (_160 > 0.0) ? min(_160, 31.984375) : 0.0;
    float _166 = floor(_165);
    vec2 _171 = min(vec2(_166 * 0.0322580635547637939453125, (_165 - _166) * 1.01587307453155517578125), vec2(1.0));
    vec2 _172 = vec2(_160);
    bvec2 _173 = bvec2(abs(_160) <= 9.9999996802856924650656260769173e+37);
    vec2 _174 = vec2(_173.x ? _171.x : _172.x, _173.y ? _171.y : _172.y);
    float _175 = _114.w;
    float _180 = (_175 > 0.0) ? min(_175, 31.984375) : 0.0;
    float _181 = floor(_180);
    vec2 _186 = min(vec2(_181 * 0.0322580635547637939453125, (_180 - _181) * 1.01587307453155517578125), vec2(1.0));
    vec2 _187 = vec2(_175);
    bvec2 _188 = bvec2(abs(_175) <= 9.9999996802856924650656260769173e+37);
    vec2 _189 = vec2(_188.x ? _186.x : _187.x, _188.y ? _186.y : _187.y);
    vec4 _193 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _194 = _193.x;
    float _204 = 1.0 / max(_194 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    bool _215 = all(lessThanEqual(abs(_144), vec2(9.9999996802856924650656260769173e+37)));
    bool _219 = all(lessThanEqual(abs(_159), vec2(9.9999996802856924650656260769173e+37)));
    bool _223 = all(lessThanEqual(abs(_174), vec2(9.9999996802856924650656260769173e+37)));
    bool _227 = all(lessThanEqual(abs(_189), vec2(9.9999996802856924650656260769173e+37)));
    vec4 _229 = vec4(float(_215), float(_219), float(_223), float(_227));
    vec4 _232 = abs(vec4((abs(_194 - 0.5) <= 0.5) ? (((_204 > 0.0) && (_204 < min(parameters.gSkyDepth, 65504.0))) ? _204 : 65504.0) : 65504.0) - vec4(textureLod(gInCoarseDepth, _79, 0.0).x, textureLod(gInCoarseDepth, _86, 0.0).x, textureLod(gInCoarseDepth, _89, 0.0).x, textureLod(gInCoarseDepth, _83, 0.0).x));
    vec4 _238 = (vec4(_90, _91, _90, _91) * vec4(_74.yy, _73.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _232);
    bvec4 _239 = greaterThan(_229 * vec4(lessThanEqual(abs(_232), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _240 = vec4(_239.x ? _238.x : vec4(0.0).x, _239.y ? _238.y : vec4(0.0).y, _239.z ? _238.z : vec4(0.0).z, _239.w ? _238.w : vec4(0.0).w);
    bvec4 _241 = greaterThan(_240, vec4(0.0));
    vec4 _242 = vec4(_241.x ? _240.x : vec4(0.0).x, _241.y ? _240.y : vec4(0.0).y, _241.z ? _240.z : vec4(0.0).z, _241.w ? _240.w : vec4(0.0).w);
    float _243 = dot(_242, vec4(1.0));
    vec4 _244 = vec4(_239.x ? _232.x : vec4(1.9999999360571384930131252153835e+38).x, _239.y ? _232.y : vec4(1.9999999360571384930131252153835e+38).y, _239.z ? _232.z : vec4(1.9999999360571384930131252153835e+38).z, _239.w ? _232.w : vec4(1.9999999360571384930131252153835e+38).w);
    bvec4 _253 = lessThanEqual(_244, vec4(min(min(_244.x, _244.y), min(_244.z, _244.w))));
    vec4 _254 = vec4(_253.x ? _229.x : vec4(0.0).x, _253.y ? _229.y : vec4(0.0).y, _253.z ? _229.z : vec4(0.0).z, _253.w ? _229.w : vec4(0.0).w);
    vec4 _259 = _242 / vec4(_243);
    vec4 _263 = _254 / vec4(max(dot(_254, vec4(1.0)), 1.0));
    bvec4 _264 = bvec4((_243 >= 1.0000000031710768509710513471353e-30) && (_243 <= 9.9999996802856924650656260769173e+37));
    vec4 _265 = vec4(_264.x ? _259.x : _263.x, _264.y ? _259.y : _263.y, _264.z ? _259.z : _263.z, _264.w ? _259.w : _263.w);
    bvec2 _267 = bvec2(_215);
    bvec2 _271 = bvec2(_219);
    bvec2 _276 = bvec2(_223);
    bvec2 _281 = bvec2(_227);
    gOutUpsampled = vec4((((vec2(_267.x ? _144.x : vec2(0.0).x, _267.y ? _144.y : vec2(0.0).y) * _265.x) + (vec2(_271.x ? _159.x : vec2(0.0).x, _271.y ? _159.y : vec2(0.0).y) * _265.y)) + (vec2(_276.x ? _174.x : vec2(0.0).x, _276.y ? _174.y : vec2(0.0).y) * _265.z)) + (vec2(_281.x ? _189.x : vec2(0.0).x, _281.y ? _189.y : vec2(0.0).y) * _265.w), 0.0, 0.0);
}

