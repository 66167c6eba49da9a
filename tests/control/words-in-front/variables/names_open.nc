%
(rule: 5 a name without its closing sign is no variable)
(expect: alarm  K5401 at 4:3)
#<depth=5
M2
%
