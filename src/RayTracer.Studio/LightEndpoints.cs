using System.Text.Json;
using RayTracer.Session;
using static RayTracer.Studio.DocumentEndpoints;

namespace RayTracer.Studio;

/// <summary>Balances the lights of rendered pictures.</summary>
internal static class LightEndpoints
{
    /// <summary>Adds the requests.</summary>
    public static void MapLights(this RouteGroupBuilder api, StudioSession session)
    {
        RouteGroupBuilder lights = api.MapGroup("/lights");
        lights.MapPost("/render", (SaveRequest r) => Started(session, session.Lights.Render(Needed(r.Path, "path"), r.Overwrite)));
        lights.MapPost("/open", (SaveRequest r) => Answers.Json(new { lights = session.Lights.Open(Needed(r.Path, "path")) }));
        lights.MapGet("/picture", (string? factors) =>
            Results.Bytes(session.Lights.Png(JsonSerializer.Deserialize<Dictionary<string, float[]>>(Needed(factors, "factors")) ?? []), "image/png"));
        lights.MapPost("/save", (SaveRequest r) => Started(session, session.Lights.Save(Needed(r.Path, "path"), r.Factors ?? [], r.Overwrite)));
    }

    private static IResult Started(StudioSession session, int job) => Answers.Json(new { job, revision = session.Document.Revision });

    internal sealed record SaveRequest(string? Path, Dictionary<string, float[]>? Factors, bool Overwrite = false);
}
