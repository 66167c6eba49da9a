%
O0001
(rule: F 1.6 no exponents: E is another word)
(expect: alarm PS0009 K5001 at 5:3)
X1E-3
M30
%
