O0001
(rule: F 6.4 constants have twelve digits at most, leading zeros not counted: PS0003)
(expect: #100=123456.123456)
(expect: #101=0.125)
(expect: alarm PS0003 K5004 at 8:6)
#100=123456.123456
#101=0000000000000.125
#102=1234567.123456
M30
