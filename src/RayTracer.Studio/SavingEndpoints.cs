using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Session;
using static RayTracer.Studio.DocumentEndpoints;

namespace RayTracer.Studio;

/// <summary>Writes pictures, parts, frames and layers of light as jobs, and says how the command would.</summary>
internal static class SavingEndpoints
{
    /// <summary>Adds the requests.</summary>
    public static void MapSaving(this RouteGroupBuilder api, StudioSession session)
    {
        MapPictures(api, session);
        MapBackground(api.MapGroup("/background"), session);
        MapLights(api.MapGroup("/lights"), session);
    }

    private static void MapPictures(RouteGroupBuilder api, StudioSession session)
    {
        api.MapPost("/save/picture", async (SaveRequest r) =>
            Started(session, await session.Pictures.Save(session.Pictures.Job(r.Path, r.BitDepth, r.Transparent, r.Layers ?? []), r.Overwrite, r.AsSeen)));
        api.MapGet("/picture", async (string? format, int? bitDepth, string? layers, HttpContext context) =>
        {
            string name = Path.ChangeExtension(session.Document.Place.Name, format ?? "png");
            RenderJob job = session.Pictures.Job(name, bitDepth, layers?.Split(',', StringSplitOptions.RemoveEmptyEntries) ?? []);
            byte[] bytes = await session.Pictures.Encode(job, context.RequestAborted);
            return Results.Bytes(bytes, ImageFormat.OfName(name)!.MediaType, name);
        });
        api.MapGet("/picture/formats", () => Results.Json(new { formats = PictureSaver.Formats }));
        api.MapGet("/command", () => Results.Json(new { text = session.Pictures.Command() }));
    }

    private static void MapBackground(RouteGroupBuilder group, StudioSession session)
    {
        BackgroundRenders renders = session.Background;
        group.MapPost("/part", (PartRequest r) => Started(session, renders.Part(r.Number, r.Count, Needed(r.Path, "path"), r.Overwrite)));
        group.MapPost("/frames", (FramesRequest r) => Started(session, renders.Frames(r.First, r.Last, Needed(r.Path, "path"), r.Overwrite)));
        group.MapPost("/merge", (MergeRequest r) => Started(session, renders.Merge(Needed(r.Parts, "parts"), Needed(r.Path, "path"), r.Overwrite)));
    }

    private static void MapLights(RouteGroupBuilder group, StudioSession session)
    {
        group.MapPost("/render", (LightRequest r) => Started(session, session.Lights.Render(Needed(r.Path, "path"), r.Overwrite)));
        group.MapPost("/open", (LightRequest r) => Results.Json(new { lights = session.Lights.Open(Needed(r.Path, "path")) }));
        group.MapGet("/picture", (string? factors) =>
            Results.Bytes(session.Lights.Png(JsonSerializer.Deserialize<Dictionary<string, float[]>>(Needed(factors, "factors")) ?? []), "image/png"));
        group.MapPost("/save", (LightRequest r) => Started(session, session.Lights.Save(Needed(r.Path, "path"), r.Factors ?? [], r.Overwrite)));
    }

    private static IResult Started(StudioSession session, int job) => Results.Json(new { job, revision = session.Document.Revision });

    internal sealed record SaveRequest(string Path, int? BitDepth, string[]? Layers, bool Overwrite = false, bool AsSeen = false, bool Transparent = false);

    internal sealed record PartRequest(int Number, int Count, string? Path, bool Overwrite = false);

    internal sealed record FramesRequest(int First, int Last, string? Path, bool Overwrite = false);

    internal sealed record MergeRequest(string[]? Parts, string? Path, bool Overwrite = false);

    internal sealed record LightRequest(string? Path, Dictionary<string, float[]>? Factors, bool Overwrite = false);
}
