using RayTracer.Imaging;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>The state of the session, for pages that wait for its changes.</summary>
internal static class StateEndpoints
{
    private static readonly ToneMap[] ToneMaps = Enum.GetValues<ToneMap>();

    /// <summary>Adds the requests.</summary>
    public static void MapState(this RouteGroupBuilder api, StudioSession session, LongPoll poll)
    {
        api.MapGet("/state", async (long? after, HttpContext context) =>
        {
            await poll.Wait(session.Changes.WaitBeyond, after ?? -1, context.RequestAborted);
            return State(session);
        });
        api.MapPost("/job/cancel", (JobRequest request) =>
        {
            session.Jobs.Cancel(request.Id);
            return Answers.Done(session);
        });
    }

    // The version is read first: what changes meanwhile is told again.
    private static IResult State(StudioSession session)
    {
        long version = session.Changes.Version;
        (PictureView view, Tone tone) = (session.View, session.View.Tone);
        return Answers.Json(new
        {
            version,
            document = session.Document.Status,
            selection = session.Selection.Pointer,
            render = RenderState.Of(view),
            tone = new { tone.Exposure, tone.ToneMap, choices = ToneMaps },
            snapshots = session.Snapshots.All,
            recovery = session.Recovery.Entries,
            message = session.Notices.Newest,
            jobs = session.Jobs.Running,
        });
    }

    internal sealed record JobRequest(int Id);
}
