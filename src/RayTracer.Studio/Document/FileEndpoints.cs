using Microsoft.AspNetCore.Http.Features;
using RayTracer.Session;
using static RayTracer.Studio.DocumentEndpoints;
using static RayTracer.Studio.DocumentRequests;

namespace RayTracer.Studio;

/// <summary>The requests about files: opening, saving, dropping, bundles, the gallery, unsaved texts.</summary>
internal static class FileEndpoints
{
    /// <summary>Adds the endpoints.</summary>
    public static void MapFiles(this RouteGroupBuilder api, StudioSession session)
    {
        MapOpening(api, session);
        MapSaving(api, session);
        MapGallery(api, session.Gallery);
        api.MapPost("/recovery/discard", (Recovered request) => session.Recovery.Discard(Needed(request.Id, "id")));
    }

    private static void MapOpening(RouteGroupBuilder api, StudioSession session)
    {
        SceneFiles files = session.Files;
        api.MapPost("/file/new", (New request) => files.New(request.Discard));
        api.MapPost("/file/open", (Open request) =>
        {
            switch (request)
            {
                case { GalleryId: { } id, Discard: var discard }:
                    files.OpenGallery(id, discard);
                    break;
                case { RecoveryId: { } id, Discard: var discard }:
                    files.OpenRecovered(id, discard);
                    break;
                case { Path: var path, Discard: var discard }:
                    files.Open(Needed(path, "path"), discard);
                    break;
            }
        });
        api.MapPost("/file/cancel", () => files.CancelOpening());
        api.MapPost("/file/upload", async (HttpContext context, string? name, bool? discard) =>
        {
            // Longer bodies are refused by what counts them, with a sentence.
            if (context.Features.Get<IHttpMaxRequestBodySizeFeature>() is { IsReadOnly: false } limit)
            {
                limit.MaxRequestBodySize = Uploads.MaximumBytes + 1;
            }

            (string path, bool opened) = await files.Upload(Needed(name, "name"), context.Request.Body, discard ?? false, context.RequestAborted);
            return Results.Json(new { revision = session.Document.Revision, path, opened });
        });
    }

    private static void MapSaving(RouteGroupBuilder api, StudioSession session)
    {
        SceneFiles files = session.Files;
        api.MapPost("/file/save", (Save request) =>
        {
            string path = files.Save(request.Path, request.Overwrite);
            return Results.Json(new { revision = session.Document.Revision, path });
        });
        api.MapGet("/file/recent", () => Results.Json(new { files = files.Recent.Select(p => new { path = p, name = Path.GetFileName(p) }) }));
        api.MapGet("/file/list", (string? path, bool? named) => files.List(path, named ?? false));
        api.MapGet("/file/thumbnail", (string? path) => Results.Bytes(PictureThumbnail.Png(Needed(path, "path")), "image/png"));
        api.MapGet("/file/bundle", () =>
        {
            JsonText text = JsonText.Of(session.Document.Read);
            DocumentPlace place = session.Document.Place;
            FileStream zip = new(Path.Combine(Path.GetTempPath(), Path.GetRandomFileName()), FileMode.CreateNew, FileAccess.ReadWrite, FileShare.None, 1 << 16, FileOptions.DeleteOnClose);
            try
            {
                SceneBundle.Write(zip, text, place);
                zip.Position = 0;
            }
            catch
            {
                zip.Dispose();
                throw;
            }

            return Results.Stream(zip, "application/zip", Path.ChangeExtension(place.Name, ".zip"));
        });
    }

    private static void MapGallery(RouteGroupBuilder api, Gallery gallery)
    {
        api.MapGet("/gallery", () => Results.Json(new { groups = gallery.Groups }));
        api.MapGet("/gallery/thumbnail", async (HttpContext context, string? id) =>
        {
            byte[] picture = await gallery.Thumbnail(Needed(id, "id"), context.RequestAborted);
            return Results.Bytes(picture, picture[0] == 0xff ? "image/jpeg" : "image/png");
        });
    }
}
