%
(rule: 4 an end with another number ends nothing)
(expect: alarm  K5434 at 6:1)
(expect: called 8:1)
#31=0
o100 while [#31 LT 3]
#31=[#31+1]
o101 endwhile
M2
%
