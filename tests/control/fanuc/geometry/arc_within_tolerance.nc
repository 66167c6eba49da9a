%
O0001
(rule: F 3.5 within No.3410 the radius changes along the arc)
(expect: to X20.008 Y0 cw I10 J0)
G02X20.008Y0I10.J0F100
M30
%
