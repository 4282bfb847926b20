#include "view/server.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <csignal>

#include "output_file.hpp"
#include "view/requests.hpp"

namespace isogloss::cli::viewing {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;

/// One browser's connection: a request after the other. All of them run on one thread.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(asio::ip::tcp::socket socket, Requests& requests) : stream_(std::move(socket)), requests_(requests) {}

  void read() {
    constexpr std::chrono::seconds patience{30};
    constexpr std::uint64_t most_bytes = 1u << 14;
    parser_.emplace();
    parser_->body_limit(most_bytes);
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](const error_code& error, std::size_t) {
      if (!error) self->answer();
    });
  }

 private:
  void answer() {
    const http::request<http::string_body>& request = parser_->get();
    Answer answer{405, "text/plain; charset=utf-8", "Only GET is answered.\n"};
    if (request.method() == http::verb::get) {
      const auto target = request.target(), host = request[http::field::host];
      answer = requests_.get({target.data(), target.size()}, {host.data(), host.size()});
    }
    response_ = {};
    response_.result(answer.status);
    response_.version(request.version());
    response_.keep_alive(request.keep_alive());
    response_.set(http::field::content_type, beast::string_view(answer.type.data(), answer.type.size()));
    response_.set(http::field::cache_control, "no-store");
    response_.set("Content-Security-Policy", security_policy(true) + "; frame-ancestors 'none'");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Cross-Origin-Resource-Policy", "same-origin");
    response_.body() = std::move(answer.body);
    response_.prepare_payload();
    http::async_write(stream_, response_, [self = shared_from_this()](const error_code& error, std::size_t) {
      if (!error && self->response_.keep_alive()) self->read();
    });
  }

  beast::tcp_stream stream_;
  Requests& requests_;
  beast::flat_buffer buffer_{1u << 16};
  std::optional<http::request_parser<http::string_body>> parser_;
  http::response<http::string_body> response_;
};

void accept(asio::ip::tcp::acceptor& acceptor, Requests& requests) {
  acceptor.async_accept([&](const error_code& error, asio::ip::tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) std::make_shared<Connection>(std::move(socket), requests)->read();
    accept(acceptor, requests);
  });
}

}  // namespace

int serve(Viewer& viewer, std::uint16_t port, Session& session) {
  asio::io_context context(1);
  asio::ip::tcp::acceptor acceptor(context);
  error_code error;
  const asio::ip::tcp::endpoint here(asio::ip::address_v4::loopback(), port);
  acceptor.open(here.protocol(), error);
  if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor.bind(here, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (error) {
    session.report("IG-0652", {}, {std::to_string(port), error.message()});
    return cannot_start;
  }
  const std::uint16_t given = acceptor.local_endpoint().port();
  Requests requests(viewer, session, given);
  asio::signal_set signals(context, SIGINT, SIGTERM);
  signals.async_wait([&](const error_code&, int) { context.stop(); });
  accept(acceptor, requests);
  const int status = print("http://127.0.0.1:" + std::to_string(given) + "/\n", success);
  if (status == success) context.run();
  return status;
}

}  // namespace isogloss::cli::viewing
