#include "stream/gateway/http_answers.h"

#include <gtest/gtest.h>

namespace aeolic::stream {
namespace {

namespace http = boost::beast::http;

const std::string kToken = "0123456789abcdefABCDEF-_01234567";

HttpRules rules()
{
    return {kToken, false, "aeolic-8080", [] { return std::string("{\"state\":\"ready\"}\n"); }, {}};
}

HttpRequest request(const std::string& target, http::verb method = http::verb::get)
{
    HttpRequest request(method, target, 11);
    request.set(http::field::host, "127.0.0.1:8080");
    return request;
}

/// From a browser whose cookie holds this session.
HttpRequest ofSession(const std::string& id, const std::string& target)
{
    HttpRequest made = request(target);
    made.set(http::field::cookie, "other=1; aeolic-8080=" + id + "; last=2");
    return made;
}

/// A request as a browser makes it that has opened the address before, and the answer.
HttpResponse answerInSession(const std::string& target, HttpRules here = rules(), http::verb method = http::verb::get)
{
    HttpRequest made = ofSession(here.sessions->open(), target);
    made.method(method);
    return answer(made, here);
}

HttpRequest withToken(const std::string& path, http::verb method = http::verb::get)
{
    return request(path + "?token=" + kToken, method);
}

TEST(HttpAnswers, WithoutTheTokenEverythingIs401AndNothingElse)
{
    for (const char* target : {"/", "/status", "/stream", "/tiles", "/index.html", "/no/such/file", "/../etc/passwd",
                               "*", "http://other/", "/?token=", "/?token", "/?Token=0123456789abcdefABCDEF-_01234567"})
        for (const http::verb method : {http::verb::get, http::verb::head, http::verb::post, http::verb::options,
                                        http::verb::delete_, http::verb::trace, http::verb::unknown}) {
            const HttpResponse response = answer(request(target, method), rules());
            EXPECT_EQ(response.result(), http::status::unauthorized) << target;
            EXPECT_EQ(response.body(), "") << target;
            EXPECT_FALSE(response.keep_alive()) << target;
            for (const auto& field : response)
                EXPECT_TRUE(field.name() == http::field::content_length || field.name() == http::field::connection)
                    << target << " tells " << field.name_string();
        }
}

/// An old link opens a page that says what to do. It tells the same to everybody, and names no file.
TEST(HttpAnswers, APersonWithoutTheTokenIsToldWhatToDo)
{
    const auto asked = [](const char* field, const char* value, const char* target, http::verb method) {
        HttpRequest made = request(target, method);
        made.set(field, value);
        return answer(made, rules());
    };
    const HttpResponse page = asked("Sec-Fetch-Dest", "document", "/", http::verb::get);
    EXPECT_EQ(page.result(), http::status::unauthorized);
    EXPECT_EQ(page[http::field::content_type], "text/html; charset=utf-8");
    EXPECT_NE(page.body().find("Open the whole address"), std::string::npos);
    EXPECT_EQ(page.body().find("src="), std::string::npos) << "nothing else is given away";
    EXPECT_EQ(page.body().find("href="), std::string::npos);
    EXPECT_FALSE(page.keep_alive());
    EXPECT_EQ(page.count(http::field::set_cookie), 0u);
    const HttpResponse elsewhere = asked("Accept", "text/html,*/*;q=0.8", "/no/such/<b>file", http::verb::get);
    EXPECT_EQ(elsewhere.result(), http::status::unauthorized);
    EXPECT_EQ(elsewhere.body(), page.body());
    EXPECT_EQ(asked("Accept", "text/html", "/", http::verb::head).body(), "");
    EXPECT_EQ(asked("Accept", "text/html", "/", http::verb::post).body(), "");
    EXPECT_EQ(asked("Accept", "*/*", "/status", http::verb::get).body(), "");
    EXPECT_EQ(asked("Sec-Fetch-Dest", "script", "/main.js", http::verb::get).body(), "");
}

TEST(HttpAnswers, TheTokenComesInTheQueryOrAsABearer)
{
    EXPECT_TRUE(mayEnter(withToken("/"), rules()));
    EXPECT_TRUE(mayEnter(request("/?a=b&token=" + kToken + "&c"), rules()));
    HttpRequest bearer = request("/status");
    bearer.set(http::field::authorization, "Bearer " + kToken);
    EXPECT_TRUE(mayEnter(bearer, rules()));
}

TEST(HttpAnswers, ASessionEntersByItsCookieAndTheTokenIsNone)
{
    const HttpRules here = rules();
    const std::string id = here.sessions->open();
    EXPECT_TRUE(mayEnter(ofSession(id, "/status"), here));
    EXPECT_FALSE(mayEnter(ofSession(id, "/status"), rules())) << "another server's";
    EXPECT_FALSE(mayEnter(ofSession(kToken, "/status"), here)) << "every port of the host gets cookies";
    EXPECT_FALSE(mayEnter(request("/status?token=" + id), here)) << "a session is no token";
}

TEST(HttpAnswers, WhoGuessesTokensGoesByATokenAndWhoHasASessionDoesNot)
{
    const HttpRules here = rules();
    EXPECT_TRUE(goesByToken(request("/stream?token=wrong"), here));
    EXPECT_TRUE(goesByToken(withToken("/"), here)) << "the right one, too: nobody shall learn from the wait";
    EXPECT_FALSE(goesByToken(request("/"), here));
    EXPECT_FALSE(goesByToken(ofSession(here.sessions->open(), "/?token=wrong"), here));
    HttpRequest bearer = request("/status");
    bearer.set(http::field::authorization, "Bearer x");
    EXPECT_TRUE(goesByToken(bearer, here));
}

TEST(HttpAnswers, NothingButTheWholeTokenWillDo)
{
    std::vector<std::string> wrong{"",           " ",          kToken.substr(1),     kToken.substr(0, 31),
                                   kToken + "0", " " + kToken, std::string(32, '0'), std::string(5000, 'x')};
    for (std::size_t at = 0; at < kToken.size(); ++at) {
        wrong.push_back(kToken);
        wrong.back()[at] ^= 1;
    }
    for (const std::string& token : wrong) {
        EXPECT_FALSE(mayEnter(request("/?token=" + token), rules())) << token;
        HttpRequest bearer = request("/");
        bearer.set(http::field::authorization, "Bearer " + token);
        EXPECT_FALSE(mayEnter(bearer, rules())) << token;
        HttpRequest cookie = request("/");
        cookie.set(http::field::cookie, "aeolic-8080=" + token);
        EXPECT_EQ(mayEnter(cookie, rules()), false) << token;
    }
    for (const char* scheme : {"", "Basic ", "Bearer", "bearer=", "Bearer  "}) {
        HttpRequest other = request("/");
        other.set(http::field::authorization, scheme + kToken);
        EXPECT_FALSE(mayEnter(other, rules())) << scheme;
    }
    for (const char* name : {"aeolic-8081", "aeolic", "x-aeolic-8080", "aeolic-80801", ""}) {
        const HttpRules here = rules();
        HttpRequest other = request("/");
        other.set(http::field::cookie, std::string(name) + "=" + here.sessions->open());
        EXPECT_FALSE(mayEnter(other, here)) << name;
    }
    EXPECT_FALSE(mayEnter(request("/?xtoken=" + kToken), rules()));
    EXPECT_FALSE(mayEnter(request("/token=" + kToken), rules())) << "that is a path";
}

TEST(HttpAnswers, WithoutATokenOfTheServersNoneIsAskedFor)
{
    HttpRules open = rules();
    open.token = "";
    EXPECT_TRUE(mayEnter(request("/"), open));
    EXPECT_TRUE(mayEnter(request("/?token=x"), open));
    EXPECT_EQ(answer(request("/"), open).count(http::field::set_cookie), 0u);
}

TEST(HttpAnswers, WithoutATokenAPageThatHadItsNamePointedHereIsAStranger)
{
    HttpRules open = rules();
    open.token = "";
    open.names = {"node7"};
    const auto entersAs = [&](const std::string& host) {
        HttpRequest named = request("/status");
        named.set(http::field::host, host);
        return mayEnter(named, open);
    };
    for (const char* own :
         {"127.0.0.1:8080", "192.168.7.2", "localhost:8080", "LocalHost", "[::1]:8080", "node7:80", ""})
        EXPECT_TRUE(entersAs(own)) << own;
    for (const char* other :
         {"evil.example:8080", "evil.example", "localhost.evil.example", "127.0.0.1.evil.example", "node70", "x"})
        EXPECT_FALSE(entersAs(other)) << other;
}

TEST(HttpAnswers, OnlyTheOwnPageAndProgramsMayOpenAStream)
{
    EXPECT_TRUE(isOwnOrigin(request("/stream"), rules())) << "a program";
    const auto from = [](const std::string& origin, bool secure = false) {
        HttpRequest page = request("/stream");
        page.set(http::field::origin, origin);
        HttpRules here = rules();
        here.secure = secure;
        return isOwnOrigin(page, here);
    };
    EXPECT_TRUE(from("http://127.0.0.1:8080"));
    EXPECT_TRUE(from("https://127.0.0.1:8080", true));
    for (const char* other :
         {"https://127.0.0.1:8080", "http://127.0.0.1:8081", "http://127.0.0.1", "null", "http://evil.example",
          "http://127.0.0.1:8080.evil.example", "http://127.0.0.1:8080/", "x"})
        EXPECT_FALSE(from(other)) << other;
    EXPECT_FALSE(from("http://127.0.0.1:8080", true));
}

/// A notebook is another server, perhaps behind a proxy that talks HTTPS.
TEST(HttpAnswers, ANotebookMayHoldThePageWhereItIsMeantTo)
{
    HttpRules notebook = rules();
    notebook.embedded = true;
    HttpRequest page = request("/stream");
    page.set(http::field::host, "hub.example");
    page.set(http::field::origin, "https://hub.example");
    EXPECT_TRUE(isOwnOrigin(page, notebook));
    EXPECT_FALSE(isOwnOrigin(page, rules()));
    page.set(http::field::origin, "https://evil.example");
    EXPECT_FALSE(isOwnOrigin(page, notebook));
    HttpRequest asked = request("/");
    asked.set(http::field::authorization, "Bearer " + kToken);
    const std::string policy(answer(asked, notebook)["Content-Security-Policy"]);
    EXPECT_NE(policy.find("frame-ancestors 'self' http://localhost:* http://127.0.0.1:*"), std::string::npos) << policy;
    EXPECT_EQ(policy.find("frame-ancestors *"), std::string::npos);
}

TEST(HttpAnswers, ThePage)
{
    for (const char* path : {"/", "/index.html"}) {
        const HttpResponse page = answerInSession(path);
        EXPECT_EQ(page.result(), http::status::ok);
        EXPECT_EQ(page[http::field::content_type], "text/html; charset=utf-8");
        EXPECT_NE(page.body().find("<!doctype html>"), std::string::npos);
        EXPECT_EQ(page["X-Content-Type-Options"], "nosniff");
        EXPECT_EQ(page["Referrer-Policy"], "no-referrer");
        EXPECT_EQ(page[http::field::cache_control], "no-store");
        const std::string policy(page["Content-Security-Policy"]);
        EXPECT_NE(policy.find("default-src 'none'"), std::string::npos);
        EXPECT_NE(policy.find("script-src 'self';"), std::string::npos);
        EXPECT_NE(policy.find("frame-ancestors 'none'"), std::string::npos);
        EXPECT_EQ(policy.find("unsafe"), std::string::npos);
        EXPECT_EQ(page.count(http::field::server), 0u) << "no more than is needed";
    }
}

TEST(HttpAnswers, ThePageConnectsToItsOwnHostAlone)
{
    const auto connections = [](const std::string& host, bool secure, bool direct) {
        HttpRules here = rules();
        here.secure = secure;
        here.direct = direct;
        HttpRequest page = ofSession(here.sessions->open(), "/");
        page.set(http::field::host, host);
        std::string policy(answer(page, here)["Content-Security-Policy"]);
        policy = policy.substr(policy.find("connect-src ") + 12);
        return policy.substr(0, policy.find(';'));
    };
    EXPECT_EQ(connections("node7:8080", false, false), "'self' ws://node7:8080");
    EXPECT_EQ(connections("[::1]:8443", true, false), "'self' wss://[::1]:8443");
    EXPECT_EQ(connections("node7:8080", false, true), "'self' ws: wss:") << "ranks may be anywhere";
    for (const char* odd : {"", "*", "x; script-src *", "x ws:", "x,y", "x'y"})
        EXPECT_EQ(connections(odd, false, false), "'self'") << odd;
}

TEST(HttpAnswers, ThePageAskedForWithTheTokenOpensASessionAndGoesOnWithoutIt)
{
    const HttpRules here = rules();
    const HttpResponse first = answer(withToken("/"), here);
    EXPECT_EQ(first.result(), http::status::see_other);
    EXPECT_EQ(first[http::field::location], "./");
    EXPECT_EQ(first[http::field::cache_control], "no-store");
    EXPECT_EQ(first["Referrer-Policy"], "no-referrer") << "the address holds the token";
    EXPECT_EQ(first.body(), "");
    const std::string cookie(first[http::field::set_cookie]);
    EXPECT_EQ(cookie.find(kToken), cookie.npos);
    ASSERT_TRUE(cookie.starts_with("aeolic-8080="));
    const std::string id = cookie.substr(12, cookie.find(';') - 12);
    EXPECT_EQ(cookie, "aeolic-8080=" + id + "; Path=/; HttpOnly; SameSite=Strict");
    EXPECT_EQ(answer(ofSession(id, "/"), here).result(), http::status::ok);
    EXPECT_EQ(answer(ofSession(id, "/"), here).count(http::field::set_cookie), 0u);
    HttpRules secure = rules();
    secure.secure = true;
    EXPECT_TRUE(std::string(answer(withToken("/"), secure)[http::field::set_cookie]).ends_with("; Secure"));
}

TEST(HttpAnswers, TheRestOfTheAddressStays)
{
    for (const auto& [asked, then] :
         {std::pair{"/index.html?a=b&token=", "./index.html?a=b"}, std::pair{"/?a=b&c&token=", "./?a=b&c"},
          std::pair{"/net/session.js?token=", "./session.js"}})
        EXPECT_EQ(answer(request(asked + kToken), rules())[http::field::location], then) << asked;
    EXPECT_EQ(answer(request("/?token=" + kToken + "&x=1"), rules())[http::field::location], "./?x=1");
}

TEST(HttpAnswers, WhoHasASessionKeepsItWhateverTheAddressSays)
{
    const HttpRules here = rules();
    const std::string id = here.sessions->open();
    for (const std::string& token : {kToken, std::string("wrong")}) {
        const HttpResponse again = answer(ofSession(id, "/?token=" + token), here);
        EXPECT_EQ(again.result(), http::status::see_other);
        EXPECT_EQ(again[http::field::location], "./");
        EXPECT_EQ(again.count(http::field::set_cookie), 0u);
    }
    EXPECT_EQ(here.sessions->count(), 1u);
}

TEST(HttpAnswers, NobodyIsSentToAnotherHost)
{
    for (const char* target :
         {"//evil.example/?token=", "http://evil.example/?token=", "/\\evil.example?token=", "?token="})
        EXPECT_EQ(answer(request(target + kToken), rules()).result(), http::status::not_found) << target;
}

// A browser does not bring a cookie of SameSite=Strict where a page of another site has led to the redirect.
TEST(HttpAnswers, WhoComesFromAnotherSiteGetsThePageAtOnce)
{
    const auto status = [](const char* field, const char* value) {
        HttpRequest page = withToken("/");
        page.set(field, value);
        const HttpResponse response = answer(page, rules());
        EXPECT_EQ(response.count(http::field::set_cookie), 1u) << field << value;
        return response.result();
    };
    EXPECT_EQ(status("Sec-Fetch-Site", "cross-site"), http::status::ok);
    EXPECT_EQ(status("Upgrade-Insecure-Requests", "1"), http::status::ok) << "a browser that does not say";
    for (const char* near : {"none", "same-origin", "same-site"})
        EXPECT_EQ(status("Sec-Fetch-Site", near), http::status::see_other) << near;
}

TEST(HttpAnswers, ProgramsAreAnsweredWithoutASession)
{
    const HttpRules here = rules();
    EXPECT_EQ(answer(withToken("/status"), here).result(), http::status::ok);
    HttpRequest bearer = request("/");
    bearer.set(http::field::authorization, "Bearer " + kToken);
    EXPECT_EQ(answer(bearer, here).result(), http::status::ok);
    answer(withToken("/", http::verb::head), here);
    answer(withToken("/nothing"), here);
    answer(request("/?token=wrong"), here);
    EXPECT_EQ(here.sessions->count(), 0u);
}

TEST(HttpAnswers, StatusIsFreshJsonThatNobodyGuessesAt)
{
    const HttpResponse status = answer(withToken("/status"), rules());
    EXPECT_EQ(status.result(), http::status::ok);
    EXPECT_EQ(status.body(), "{\"state\":\"ready\"}\n");
    EXPECT_EQ(status[http::field::content_type], "application/json; charset=utf-8");
    EXPECT_EQ(status[http::field::cache_control], "no-store");
    EXPECT_EQ(status["X-Content-Type-Options"], "nosniff");
    EXPECT_EQ(status.count(http::field::server), 0u);
}

TEST(HttpAnswers, FilesInFoldersHaveTheirPaths)
{
    const HttpResponse script = answerInSession("/net/session.js");
    EXPECT_EQ(script.result(), http::status::ok);
    EXPECT_EQ(script[http::field::content_type], "text/javascript; charset=utf-8");
    EXPECT_EQ(answerInSession("/panel/panel.css").result(), http::status::ok);
}

TEST(HttpAnswers, WhatIsNotThereIs404WithoutABody)
{
    for (const char* path : {"/nothing", "/status/", "/Status", "//", "/../index.html", "/%2e%2e/index.html",
                             "/index.html/", "/stream", "", "index.html", "*", "/session.js", "/net", "/net/"}) {
        const HttpResponse response = answer(withToken(path), rules());
        EXPECT_EQ(response.result(), http::status::not_found) << path;
        EXPECT_EQ(response.body(), "") << path;
    }
}

TEST(HttpAnswers, OtherMethodsAre405)
{
    for (const http::verb method : {http::verb::post, http::verb::put, http::verb::delete_, http::verb::options,
                                    http::verb::trace, http::verb::connect, http::verb::unknown}) {
        const HttpResponse response = answer(withToken("/", method), rules());
        EXPECT_EQ(response.result(), http::status::method_not_allowed);
        EXPECT_EQ(response.body(), "");
    }
}

TEST(HttpAnswers, HeadIsGetWithoutTheBody)
{
    const HttpResponse get = answerInSession("/"), head = answerInSession("/", rules(), http::verb::head);
    EXPECT_EQ(head.result(), http::status::ok);
    EXPECT_EQ(head.body(), "");
    EXPECT_EQ(head[http::field::content_length], get[http::field::content_length]);
    EXPECT_EQ(head[http::field::content_type], get[http::field::content_type]);
}

}  // namespace
}  // namespace aeolic::stream
