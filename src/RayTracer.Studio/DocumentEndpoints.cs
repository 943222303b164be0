using System.Numerics;
using System.Text.Json;
using RayTracer.Session;
using static RayTracer.Studio.DocumentAnswers;
using static RayTracer.Studio.DocumentRequests;

namespace RayTracer.Studio;

/// <summary>What a page does with the document: reading it, editing its text, files, the gallery.</summary>
public static class DocumentEndpoints
{
    // The catalogue never changes.
    private static readonly Lazy<byte[]> s_schema = new(() => Bytes(TypeCatalogue.Instance));

    /// <summary>Adds the document's endpoints.</summary>
    /// <param name="api">The group "/api".</param>
    /// <param name="session">The document side of the session.</param>
    /// <param name="tell">Shows the user a sentence; null where nobody listens.</param>
    public static void MapDocument(this RouteGroupBuilder api, DocumentSession session, Action<string>? tell = null)
    {
        RouteGroupBuilder guarded = api.MapGroup("");
        guarded.AddEndpointFilter(Guard);
        MapReading(guarded, session);
        MapText(guarded, session.Document);
        MapThings(guarded, session.Document, tell ?? (_ => { }));
        guarded.MapFiles(session);
    }

    private static void MapReading(RouteGroupBuilder api, DocumentSession session)
    {
        SceneDocument document = session.Document;
        api.MapGet("/document", () =>
        {
            (int revision, string text) = document.Current;
            return Json(new { revision, text });
        });
        api.MapGet("/outline", () => Json(document.Read.Root is { } root
            ? Outline.Of(document.Revision, root)
            : document.Content.LastGood is { } good ? Outline.Of(good.Revision, good.Read.Root!) : throw new DocumentException("the text cannot be read yet")));
        api.MapGet("/schema", () => Results.Bytes(s_schema.Value, "application/json"));
        api.MapGet("/value", (string? pointer) => Json(PropertyValues.At(JsonText.Of(document.Read).Root, Needed(pointer, "pointer"))));
        api.MapPost("/select", async (HttpContext context) =>
        {
            session.Selection.Select((await Body<At>(context)).Pointer);
            return Revision(document);
        });
    }

    private static void MapText(RouteGroupBuilder api, SceneDocument document)
    {
        api.MapPost("/document/text", async (HttpContext context) =>
        {
            Replace change = await Body<Replace>(context);
            bool isTaken = document.TryReplace(change.BaseRevision, change.From, change.To, Needed(change.Insert, "insert"), change.Gesture);
            (int revision, string text) = document.Current;
            return isTaken ? Json(new { revision }) : Json(new { error = "the text has changed meanwhile", revision, text }, StatusCodes.Status409Conflict);
        });
        api.MapPost("/document/set", async (HttpContext context) =>
        {
            Set set = await Body<Set>(context);
            string pointer = Needed(set.Pointer, "pointer");
            return Json(new { revision = document.Change(JsonPointer.Last(pointer), set.Gesture, text => Changed(text, set, pointer)) });
        });
        api.MapPost("/document/undo", () =>
        {
            document.Undo();
            return Revision(document);
        });
        api.MapPost("/document/redo", () =>
        {
            document.Redo();
            return Revision(document);
        });
    }

    private static void MapThings(RouteGroupBuilder api, SceneDocument document, Action<string> tell)
    {
        api.MapPost("/document/add", async (HttpContext context) =>
        {
            Add add = await Body<Add>(context);
            (string family, string type) = (Needed(add.Family, "family"), Needed(add.Type, "type"));
            return Pointed(document, $"add {type}", text => SceneThings.Add(text, family, type, add.Near, add.File));
        });
        api.MapPost("/document/duplicate", async (HttpContext context) =>
        {
            string pointer = Needed((await Body<At>(context)).Pointer, "pointer");
            return Pointed(document, "duplicate", text => SceneThings.Duplicate(text, pointer));
        });
        api.MapPost("/document/rename", async (HttpContext context) =>
        {
            Rename rename = await Body<Rename>(context);
            (string pointer, string name) = (Needed(rename.Pointer, "pointer"), Needed(rename.Name, "name"));
            return Pointed(document, "rename", text => SceneThings.Rename(text, pointer, name));
        });
        api.MapPost("/document/delete", async (HttpContext context) =>
        {
            string[] pointers = (await Body<Many>(context)).Pointers ?? throw new DocumentException("the request needs \"pointers\"");
            IReadOnlyList<string> notes = [];
            int revision = document.Change("delete", null, text =>
            {
                (text, notes) = SceneThings.Delete(text, pointers);
                return text;
            });
            foreach (string note in notes)
            {
                tell(note);
            }

            return Json(new { revision, notes });
        });
        api.MapPost("/document/place", async (HttpContext context) =>
        {
            Place place = await Body<Place>(context);
            string pointer = Needed(place.Pointer, "pointer");
            return Json(new { revision = document.Change("place", place.Gesture, text => Placed(text, place, pointer)) });
        });
    }

    private static JsonText Changed(JsonText text, Set set, string pointer)
    {
        if (set.Reset)
        {
            return JsonPointer.Find(text.Root, pointer) is null ? text : text.Remove(pointer);
        }

        if (set.Json is not null)
        {
            return text.SetText(pointer, set.Json);
        }

        return set.Value.ValueKind == JsonValueKind.Undefined
            ? throw new DocumentException("the request needs \"value\" or \"json\"")
            : text.Set(pointer, System.Text.Json.Nodes.JsonNode.Parse(set.Value.GetRawText()));
    }

    private static JsonText Placed(JsonText text, Place place, string pointer)
    {
        Vector3? center = place.Center is null ? null : Vector(place.Center, "center");
        text = place.Scale is null ? text : ShapePlacement.Scale(text, pointer, Vector(place.Scale, "scale"), center);
        if (place.Rotate is { } turn)
        {
            text = ShapePlacement.Rotate(text, pointer, Vector(turn.Axis, "axis"), turn.Degrees, turn.Center is null ? center : Vector(turn.Center, "center"));
        }

        return place.Translate is null ? text : ShapePlacement.Translate(text, pointer, Vector(place.Translate, "translate"));
    }

    private static Vector3 Vector(float[]? numbers, string name) =>
        numbers is { Length: 3 } ? new(numbers) : throw new DocumentException($"\"{name}\" needs three numbers");

    private static IResult Pointed(SceneDocument document, string label, Func<JsonText, (JsonText, string)> change)
    {
        string pointer = "";
        int revision = document.Change(label, null, text =>
        {
            (text, pointer) = change(text);
            return text;
        });
        return Json(new { revision, pointer });
    }

    private static IResult Revision(SceneDocument document) => Json(new { revision = document.Revision });
}
