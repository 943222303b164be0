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

    private static IResult State(StudioSession session)
    {
        SessionState state = SessionState.Of(session);
        return Answers.Json(new
        {
            state.Version,
            state.Document,
            state.Selection,
            render = RenderState.Of(state.Render, state.Settings),
            tone = new { state.Tone.Exposure, state.Tone.ToneMap, choices = ToneMaps },
            state.Snapshots,
            state.Recovery,
            message = state.Notice,
            state.Jobs,
        });
    }

    internal sealed record JobRequest(int Id);
}
