# Links of articles as ./dev docs needs them: its pages lie in one folder, with pictures beside them, and the files that
# articles speak of in source/.
s#\]\((\.\./)*(docs/)?images/#](#g
s#\]\((\.\./)*include/mimo/mimo\.h\)#](mimo_8h.html)#g
s#\]\(data/#](source/docs/data/#g
s#\]\((\.\./)*((examples|CITATION\.cff|LICENSE)(/[^)]*)?)\)#](source/\2)#g
# doxygen has other names for headings.
s#\.md\#[^)]*\)#.md)#g
