using Microsoft.AspNetCore.Http.Features;
using RayTracer.Session;
using static RayTracer.Studio.DocumentAnswers;
using static RayTracer.Studio.DocumentRequests;

namespace RayTracer.Studio;

/// <summary>What a page does with files: opening, saving, dropping, bundles, the gallery, texts that were not saved.</summary>
internal static class FileEndpoints
{
    /// <summary>Adds the endpoints.</summary>
    public static void MapFiles(this RouteGroupBuilder api, DocumentSession session)
    {
        MapOpening(api, session);
        MapSaving(api, session);
        MapGallery(api, session.Gallery);
        api.MapPost("/recovery/discard", async (HttpContext context) =>
        {
            session.Recovery.Discard(Needed((await Body<Recovered>(context)).Id, "id"));
            return Revision(session);
        });
    }

    private static void MapOpening(RouteGroupBuilder api, DocumentSession session)
    {
        SceneFiles files = session.Files;
        api.MapPost("/file/new", async (HttpContext context) =>
        {
            files.New((await Body<New>(context)).Discard);
            return Revision(session);
        });
        api.MapPost("/file/open", async (HttpContext context) =>
        {
            switch (await Body<Open>(context))
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

            return Revision(session);
        });
        api.MapPost("/file/upload", async (HttpContext context, string? name, bool? discard) =>
        {
            // Longer bodies are refused by what counts them, with a sentence.
            if (context.Features.Get<IHttpMaxRequestBodySizeFeature>() is { IsReadOnly: false } limit)
            {
                limit.MaxRequestBodySize = Uploads.MaximumBytes + 1;
            }

            (string path, bool opened) = await files.Upload(Needed(name, "name"), context.Request.Body, discard ?? false, context.RequestAborted);
            return Json(new { revision = session.Document.Revision, path, opened });
        });
    }

    private static void MapSaving(RouteGroupBuilder api, DocumentSession session)
    {
        SceneFiles files = session.Files;
        api.MapPost("/file/save", async (HttpContext context) =>
        {
            Save save = await Body<Save>(context);
            string path = files.Save(save.Path, save.Overwrite);
            return Json(new { revision = session.Document.Revision, path });
        });
        api.MapGet("/file/recent", () => Json(new { files = files.Recent.Select(p => new { path = p, name = Path.GetFileName(p) }) }));
        api.MapGet("/file/list", (string? path) => Json(files.List(path)));
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
        api.MapGet("/gallery", () => Json(new { groups = gallery.Groups }));
        api.MapGet("/gallery/thumbnail", async (HttpContext context, string? id) => Results.Bytes(await gallery.Thumbnail(Needed(id, "id"), context.RequestAborted), "image/png"));
    }

    private static IResult Revision(DocumentSession session) => Json(new { revision = session.Document.Revision });
}
