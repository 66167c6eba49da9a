%
O0001
(rule: F 1.7 an unknown word behind a comma: PS0009)
(expect: alarm PS0009 K5001 at 5:8)
G01X40.,B2.F200.
Y30.
M30
%
