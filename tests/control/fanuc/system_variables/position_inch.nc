%
O0001
(rule: F 6.5 positions are multiples of the increment)
(expect: #100=1)
(expect: #101=1)
(expect: #102=1)
(expect: #103=703.923)
G20G00X1.Y0.25
IF[#5001EQ1.]THEN#100=1
IF[#5042EQ0.25]THEN#101=1
G10L2P2X1.
IF[#5241EQ1.]THEN#102=1
G21
#5261=703.92304845
#103=#5261
M30
%
