// The parts of Asio and Beast that are not templates are compiled here, once (BOOST_ASIO_SEPARATE_COMPILATION and
// BOOST_BEAST_SEPARATE_COMPILATION in cmake/dependencies.cmake), instead of in every file that includes them.
#include <utility>  // Boost 1.74 forgets it.

#include <boost/asio/impl/src.hpp>
#include <boost/asio/ssl/impl/src.hpp>
#include <boost/beast/src.hpp>
