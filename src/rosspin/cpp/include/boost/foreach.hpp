#ifndef ROSSPIN_BOOST_FOREACH_HPP
#define ROSSPIN_BOOST_FOREACH_HPP

#define BOOST_FOREACH(item, items) for (item : items)

#endif
