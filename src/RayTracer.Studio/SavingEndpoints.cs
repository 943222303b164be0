using RayTracer.Imaging;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>Writes pictures, and says how the command would.</summary>
internal static class SavingEndpoints
{
    /// <summary>Adds the requests.</summary>
    public static void MapSaving(this RouteGroupBuilder api, StudioSession session)
    {
        api.MapPost("/save/picture", async (SaveRequest request) =>
        {
            PictureRequest picture = PictureRequest.Of(request.BitDepth, request.Layers ?? []);
            int job = await session.Pictures.Save(request.Path, picture, request.Overwrite);
            return Answers.Json(new { job, revision = session.Document.Revision });
        });
        api.MapGet("/picture", async (string? format, int? bitDepth, string? layers, HttpContext context) =>
        {
            PictureRequest picture = PictureRequest.Of(bitDepth, layers?.Split(',', StringSplitOptions.RemoveEmptyEntries) ?? []);
            string extension = $".{format ?? "png"}";
            byte[] bytes = await session.Pictures.Encode(extension, picture, context.RequestAborted);
            string type = ImageFormat.OfName(extension)!.MediaType;
            return Results.Bytes(bytes, type, Path.ChangeExtension(session.Document.Place.Name, extension));
        });
        api.MapGet("/picture/formats", () => Answers.Json(new { formats = PictureSaver.Formats }));
        api.MapGet("/command", () => Answers.Json(new { text = session.Pictures.Command() }));
    }

    internal sealed record SaveRequest(string Path, int? BitDepth, string[]? Layers, bool Overwrite = false);
}
