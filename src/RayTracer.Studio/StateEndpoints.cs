using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>The state of the session, for pages that wait for its changes.</summary>
internal static class StateEndpoints
{
    private static readonly ToneMap[] ToneMaps = Enum.GetValues<ToneMap>();
    private static readonly ExposureRule[] ExposureRules = Enum.GetValues<ExposureRule>();

    /// <summary>Adds the requests.</summary>
    public static void MapState(this RouteGroupBuilder api, StudioSession session, LongPoll poll)
    {
        api.MapGet("/state", async (long? after, HttpContext context) =>
        {
            await poll.Wait(session.Changes.WaitBeyond, after ?? -1, context.RequestAborted);
            return State(session);
        });
        api.MapPost("/job/cancel", (JobRequest request) => session.Jobs.Cancel(request.Id));
    }

    private static StudioState State(StudioSession session)
    {
        SessionState state = SessionState.Of(session);
        return new(
            state.Version, state.Document, state.Selection, state.Selected, state.Hidden, state.Locked, RenderState.Of(state.Render, state.Settings), new(state.Stops, state.Tone.Exposure.Rule, state.Tone.ToneMap, ToneMaps, ExposureRules),
            state.View, state.Snapshots, state.Recovery, state.Notice, state.Lights, state.Jobs, session.Timeline.State);
    }

    internal sealed record JobRequest(int Id);
}

/// <summary>The state of a session as pages get it.</summary>
internal sealed record StudioState(
    long Version, DocumentStatus Document, string? Selection, IReadOnlyList<string> Selected, IReadOnlyList<string> Hidden, IReadOnlyList<string> Locked, RenderState Render, ToneState Tone, ViewStatus View, IReadOnlyList<Snapshot> Snapshots,
    IReadOnlyList<RecoveryEntry> Recovery, Notice? Message, IReadOnlyList<MixedLight>? Lights, IReadOnlyList<Job> Jobs, TimeState Time);

/// <summary>The exposure in stops, who decides on it, the tone map of the screen, and what there is to choose from.</summary>
internal sealed record ToneState(float Exposure, ExposureRule Rule, ToneMap ToneMap, IReadOnlyList<ToneMap> Choices, IReadOnlyList<ExposureRule> Rules);

/// <summary>The progress of the picture, as reported to pages.</summary>
internal sealed record RenderState(
    string Status, int Width, int Height, int Samples, int SamplesTotal, double RaysPerSecond, double Seconds, double? SecondsLeft, double? Noise,
    int Threads, int Cores, string Map, int[]? Region, RenderQuality? Quality, bool IsPreview, long BadSamples, bool FiltersMotion, string? Legend, string Edition, IReadOnlyList<string> Editions)
{
    /// <summary>That of a view, by what is known of its picture and what the user wants.</summary>
    public static RenderState Of(RenderStatus status, ViewSettings settings)
    {
        int[]? region = settings.Region is { } r ? [r.X, r.Y, r.Width, r.Height] : null;
        return new(
            status.Status, status.Width, status.Height, status.Samples, status.SamplesTotal, status.RaysPerSecond, status.Seconds, status.SecondsLeft, status.Noise,
            settings.Threads, Environment.ProcessorCount, settings.Map.Name, region, settings.Quality, status.IsPreview, status.BadSamples, settings.FiltersMotion, status.Legend,
            settings.Edition ?? ViewSettings.Editions[0], ViewSettings.Editions);
    }
}
