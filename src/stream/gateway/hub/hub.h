#pragma once

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "description/choices.h"
#include "stream/gateway/hub/viewer.h"

namespace aeolic::stream {

/// What `GET /status` tells.
struct HubStatus {
    std::string state;
    int ranks = 0, viewers = 0, restarts = 0;
    std::uint64_t frames = 0;
};

/// The middle of the gateway: viewers and their views on one side, the render job on the other. It decides which
/// view is drawn next and which viewer gets it, and survives the job. It knows no sockets and no processes. Not
/// thread-safe: the one thread of the gateway makes every call.
class Hub {
public:
    struct Options {
        SceneDescription scene;
        int largestSide = 4096;
        std::size_t maxViewers = 64;
        std::uint64_t mostSamples = kMostSamples;           ///< What one picture may cost (samplesOf()).
        std::uint64_t frameBytes = std::uint64_t{1} << 30;  ///< What all pictures that are kept or wait may take.
        std::chrono::seconds drawLimit{60};                 ///< A frame that takes longer ends the job.
        std::chrono::seconds loadLimit{600};                ///< A load that makes no progress for longer ends the job.
        bool ofProgram = false;      ///< The job is a program with a scene of its own, which may change and be steered.
        std::optional<Codec> codec;  ///< `jpeg`: for moving pictures alone. None: chosen by what the viewer can decode
                                     ///< and the line bears.
    };
    static constexpr auto kSettled = std::chrono::seconds(10);
    static constexpr auto kNoticeable = std::chrono::milliseconds(250);  ///< A load that takes longer is told of.
    static constexpr auto kPatience =
        std::chrono::seconds(2);  ///< A change waits so long for its viewer to see the last.
    static constexpr auto kNextView = std::chrono::milliseconds(100);  ///< A moving viewer asks again so soon.
    static constexpr auto kMovesFor = std::chrono::seconds(3);  ///< The scene rests if its mover is silent so long.
    static constexpr auto kBetweenStarts = std::chrono::seconds(5);  ///< That viewers ask for.
    static constexpr double kTooManyMs = 2;  ///< What a view counts as beyond viewsPerSecond of Welcome.
    static constexpr auto kTooManyRest = std::chrono::milliseconds(8);  ///< And how long its sender waits for it.
    static constexpr auto kLongestRest = std::chrono::minutes(5);
    static constexpr auto kLong = std::chrono::seconds(2);  ///< A picture that takes longer is paid for beforehand.
    static constexpr auto kSoon = std::chrono::milliseconds(500);  ///< A viewer with so new a picture will ask again.
    static constexpr auto kUntrueRest = std::chrono::seconds(10);  ///< After a Shown of a frame not begun.
    static constexpr auto kPenalty = std::chrono::seconds(60);     ///< Without changes, after one that ended the job.
    using Now = std::function<SteadyClock::time_point()>;

    /// `toJob` sends a message to every rank; messages keep their order.
    Hub(Options options, std::function<void(WireMessage)> toJob, Now now = SteadyClock::now);

    // ---- Viewers. `port` must stay until leave().
    bool isFull() const { return viewers_.size() >= options_.maxViewers; }
    std::uint32_t join(ViewerPort& port, const Hello& hello);
    void leave(std::uint32_t viewer);
    /// Forgets all viewers. Their sessions may still leave, but hear nothing any more.
    void dismissAll() { viewers_.clear(); }
    /// Throws ProtocolError; the caller then hangs up.
    void receive(std::uint32_t viewer, const MessageView& message);
    /// A frame has left its port's queue.
    void frameWritten(std::uint32_t id) { goOn(viewer(id)); }

    /// Has to be called several times a second. Begins what had to wait for its time.
    void tick();
    /// Why the job has to be ended, if it has to: it draws one frame or loads one scene for too long.
    std::optional<std::string> overdue() const;

    // ---- The job.
    void jobStarting();
    /// `direct`: where viewers can get tiles from the ranks themselves, one place for each rank; or nothing.
    void jobStarted(int ranks, const std::vector<DirectPlace>& direct = {});
    /// A message from a rank, whole, so that it can be passed on. Throws ProtocolError; the caller then ends the job.
    void jobSaid(const WireMessage& message);
    /// `message`: how the job ended and when it is tried again. Returns whether the job was of use: it has drawn a
    /// frame, or was ready for kSettled and nobody asked for a frame.
    bool jobEnded(const std::string& message);
    void jobWaits(const std::string& message) { setState(State::restarting, message); }
    /// Whether a viewer has asked for another start since the job was given up. Forgets it.
    bool takeStartAskedFor() { return std::exchange(startAskedFor_, false); }
    void jobGivenUp(const std::string& message);
    /// The job will never start: the program to be started is not there.
    void jobCannotStart(const std::string& message);

    HubStatus status() const;
    /// Bytes of all encoded pictures that are drawn, kept for followers, or wait for viewers to read them.
    std::uint64_t frameBytes() const { return *frameBytes_; }
    /// Why the very first scene could not be loaded.
    const std::optional<std::string>& sceneError() const { return sceneError_; }
    /// Why this job could not load what the job before had loaded. The caller ends it and tries another.
    const std::optional<std::string>& loadError() const { return loadError_; }

private:
    static constexpr const char* kOtherPlaces =
        "another viewer has taken a surface away meanwhile; what was asked of the surfaces was not done";

    enum class State { loading, ready, restarting, failed };

    /// A scene that the job loads, and the viewer that asked for it (0: none).
    struct Load {
        SceneDescription scene;
        std::uint32_t askedBy = 0;
        std::uint32_t number = 0;  ///< That viewer's of the change.
        Json steer;                ///< Controls of a program, by name, and what they shall be; null: none.
        bool takesAway = false;    ///< A surface: those behind it stand one place before.
    };

    /// Something that the job can do next for a viewer.
    struct Turn {
        Viewer* viewer;
        bool isChange;  ///< Else it is a picture.
        double had;     ///< The time that counts for it.
    };

    // hub_viewers.cpp
    Viewer& viewer(std::uint32_t id) { return viewers_.at(id); }
    void onView(Viewer& viewer, ViewRequest request);
    void onShown(Viewer& viewer, std::uint32_t frame);
    void onFollow(Viewer& viewer, std::uint32_t other);
    void onStart(Viewer& viewer);
    void catchUp(Viewer& viewer);
    void goOn(Viewer& viewer);
    void toAll(const WireMessage& message);
    void offerDirect(Viewer& viewer);
    void notify(Viewer& viewer, const char* level, const std::string& message, bool ofChange = false);

    // hub_turns.cpp
    bool takeTurn();
    std::vector<Turn> turns();
    bool showChange();
    bool isAheadOfOthers(const Viewer& viewer) const;
    void charge(Viewer& viewer, double ms, std::uint64_t samples, bool isOfChange = false);
    void chargeChange(std::uint32_t viewer, SteadyClock::duration took);
    void chargeOwnPicture(Viewer& viewer, SteadyClock::duration took);
    bool looksAround(const Viewer& viewer) const;
    int othersWhoLookAround(const Viewer& viewer) const;
    SteadyClock::duration restAfterChange(const Viewer& viewer, SteadyClock::duration took) const;
    bool comesWithChange(const Viewer& viewer) const;
    bool movesScene(const Viewer& viewer) const;
    void chargeWhatWasBegun(const Drawing& drawing);
    bool looks(const Viewer& viewer, SteadyClock::duration lately) const;
    int othersWhoLook(const Viewer& viewer, SteadyClock::duration lately) const;
    SteadyClock::time_point waitsUntil(const Viewer& viewer, const SceneDescription& scene) const;
    SteadyClock::duration restAfter(SteadyClock::duration picture, int others) const;
    void tellOfWait(Viewer& viewer, SteadyClock::time_point until);
    void learnSpeed(const SceneDescription& scene, double tracedMs);
    std::chrono::milliseconds expectedTime(const SceneDescription& scene) const;
    bool mayGetAnother(const Viewer& viewer) const;

    // hub_frames.cpp
    void drawNext();
    bool draw(Viewer& viewer);
    Drawing* drawingOf(std::uint32_t frame);
    bool allCan(const Viewer& of, Codec codec) const;
    WireMessage counted(const WireMessage& tile) const;
    void saveMemory();
    DrawRequest drawRequest(const Viewer& viewer, const ViewRequest& view, bool isMoving) const;
    void onTile(const WireMessage& message, ByteView payload);
    void onFrameEnd(const WireMessage& message, ByteView payload);
    void finishIfWhole(Drawing& drawing);
    void drop(Drawing& drawing);
    void dropDrawing();

    // hub_scene.cpp
    void take(const WireMessage& message, const MessageView& view);
    void load(Load next);
    void tellOfLoad();
    void onScene(ByteView payload);
    void nameSurfaces(Json& scene, const SceneDescription& original) const;
    void onProgramsScene(Json scene);
    void onRenewed();
    void onProgress(ByteView payload);
    void onNotice(ByteView payload);
    void drawAllAgain();
    void setScene(const Json& scene);
    void tellScene(Viewer& viewer);
    void setState(State state, const std::string& message);
    WireMessage stateMessage() const;
    const char* stateName() const;

    // hub_picks.cpp
    void onPick(Viewer& viewer, PickRequest pick);
    void sendPick(Viewer& viewer);
    void sendPicks();
    void onPicked(ByteView payload);
    void failPick(std::uint32_t viewer, const std::string& message);
    void forgetPicks();

    // hub_changes.cpp
    void onChange(Viewer& viewer, ChangeRequest change);
    SceneDescription changed(const Viewer& viewer, const ChangeRequest& change) const;
    bool isOfOtherPlaces(const ChangeRequest& change) const;
    bool mayChange(const Viewer& viewer) const;
    void beginChange(Viewer& viewer);
    void answer(Viewer& viewer, std::uint32_t change);
    void refuseNewest(Viewer& viewer, std::uint32_t change, const std::string& message);
    void refuse(Viewer& viewer, std::uint32_t change, const std::string& message);
    void refuseWaiting(const std::string& message, const std::function<bool(const ChangeRequest&)>& which);
    bool sceneMoves() const;
    void restIfDue();

    Options options_;
    std::function<void(WireMessage)> toJob_;
    Now now_;
    std::map<std::uint32_t, Viewer> viewers_;
    std::uint32_t lastViewer_ = 0, lastDrawn_ = 0, lastFrame_ = 0, lastLoad_ = 0;
    std::uint64_t framesDrawn_ = 0;

    std::deque<Drawing> drawing_;  ///< The oldest frame first; frames end in that order.
    std::shared_ptr<std::uint64_t> frameBytes_ = std::make_shared<std::uint64_t>(0);
    std::size_t framesInFlight_ = 1;  ///< How many the job draws at once.
    SteadyClock::time_point lastSent_{};
    double timeGiven_ = 0;  ///< What the viewer drawn last had before, in milliseconds.
    std::array<double, choiceNames<LicMethod>.size()> samplesPerMs_{};  ///< By LicMethod; 0: not known.
    SceneDescription scene_;                            ///< The scene that is loaded, or the one to go back to.
    std::uint32_t places_ = 0;                          ///< How many times surfaces were taken away.
    std::optional<Load> loading_;                       ///< The job loads it now. One is on its way at a time.
    SteadyClock::time_point loadSent_{}, loadHeard_{};  ///< When it was sent; the last sign of progress.
    std::uint32_t changedBy_ = 0;  ///< Whose change was loaded last, until the first picture of it is begun.
    SteadyClock::time_point changesFromOfLeft_{};  ///< Of viewers that left: to connect again gains nothing.
    std::set<std::string> deadly_;                 ///< Scenes that ended a job, as JSON.
    WireMessage sceneMessage_;
    Json viewOfScene_;  ///< The camera that it has.
    std::optional<std::string> sceneError_, loadError_;
    std::optional<SteadyClock::time_point> loadedAt_;  ///< When this job had loaded a scene.

    State state_ = State::loading;
    std::string what_, message_;
    double fraction_ = 0;
    int ranks_ = 0, restarts_ = 0;
    std::vector<DirectPlace> direct_;
    bool jobRuns_ = false, drewSinceStart_ = false;
    bool startAskedFor_ = false;
    SteadyClock::time_point mayStartFrom_{};
};

/// A viewer's place in the hub. The viewer leaves when this goes, whatever ends its session.
class Seat {
public:
    Seat(Hub& hub, ViewerPort& port, const Hello& hello) : hub_(hub), viewer_(hub.join(port, hello)) {}
    ~Seat() { hub_.leave(viewer_); }
    Seat(const Seat&) = delete;
    Seat& operator=(const Seat&) = delete;

    std::uint32_t viewer() const { return viewer_; }

private:
    Hub& hub_;
    std::uint32_t viewer_;
};

}  // namespace aeolic::stream
