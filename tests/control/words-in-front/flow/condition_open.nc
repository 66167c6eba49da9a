%
(rule: 4 what is wrong in the condition is said, and not that the letter is unknown)
(expect: alarm  K5404 at 4:21)
o100 while [#31 LT 3
o100 endwhile
M2
%
