using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>The state of the session, for pages that wait for its changes.</summary>
internal static class StateEndpoints
{
    /// <summary>Adds the requests.</summary>
    public static void MapState(this RouteGroupBuilder api, StudioSession session, LongPoll poll)
    {
        api.MapGet("/state", async (long? after, HttpContext context) =>
        {
            await poll.Wait(session.Changes, after ?? -1, context.RequestAborted);
            return State(session);
        });
        api.MapPost("/job/cancel", (JobRequest request) =>
        {
            session.Jobs.Cancel(request.Id);
            return Results.NoContent();
        });
    }

    // The version is read first: what changes meanwhile is told again.
    private static IResult State(StudioSession session)
    {
        long version = session.Changes.Version;
        return Results.Json(new { version, message = session.Notices.Newest, jobs = session.Jobs.Running }, ApiJson.Options);
    }

    internal sealed record JobRequest(int Id);
}
