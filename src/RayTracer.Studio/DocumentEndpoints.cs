using System.Text.Json;
using RayTracer.Scenes;
using RayTracer.Session;
using static RayTracer.Studio.DocumentRequests;

namespace RayTracer.Studio;

/// <summary>What a page does with the document: reading it and editing its text.</summary>
internal static class DocumentEndpoints
{
    // The catalogue never changes.
    private static readonly Lazy<byte[]> Schema = new(() => JsonSerializer.SerializeToUtf8Bytes(TypeCatalogue.Instance, ApiJson.Options));

    /// <summary>Adds the requests.</summary>
    /// <param name="api">The group "/api".</param>
    /// <param name="session">The session.</param>
    public static void MapDocument(this RouteGroupBuilder api, StudioSession session)
    {
        MapReading(api, session);
        MapText(api, session);
        MapThings(api, session);
        api.MapFiles(session);
    }

    /// <summary>Something that a request must have.</summary>
    /// <exception cref="DocumentException">It has not.</exception>
    internal static T Needed<T>(T? value, string name)
        where T : class => value ?? throw new DocumentException($"the request needs \"{name}\"");

    private static void MapReading(RouteGroupBuilder api, StudioSession session)
    {
        SceneDocument document = session.Document;
        api.MapGet("/document", () =>
        {
            (int revision, string text) = document.Current;
            return Answers.Json(new { revision, text });
        });
        api.MapGet("/outline", () =>
        {
            (int revision, JsonNode root) = Readable(document);
            return Answers.Json(Outline.Of(revision, root));
        });
        api.MapGet("/schema", () => Results.Bytes(Schema.Value, "application/json"));
        api.MapGet("/value", (string? pointer) => Answers.Json(PropertyValues.At(Readable(document).Root, Needed(pointer, "pointer"))));
        api.MapPost("/select", (At request) =>
        {
            session.Selection.Select(request.Pointer);
            return Answers.Done(session);
        });
    }

    // While the text is no JSON, which happens at every other key that is typed, what it last was is still shown.
    private static (int Revision, JsonNode Root) Readable(SceneDocument document) => document.Read.Root is { } root ? (document.Revision, root)
        : document.Content.LastGood is { } good ? (good.Revision, good.Read.Root!)
        : throw new DocumentException("the text cannot be read yet");

    private static void MapText(RouteGroupBuilder api, StudioSession session)
    {
        SceneDocument document = session.Document;
        api.MapPost("/document/text", (Replace request) =>
        {
            bool isTaken = document.TryReplace(request.BaseRevision, request.From, request.To, Needed(request.Insert, "insert"), request.Gesture);
            (int revision, string text) = document.Current;
            return isTaken ? Answers.Json(new { revision })
                : Results.Json(new { error = "The text has changed meanwhile.", revision, text }, ApiJson.Options, statusCode: StatusCodes.Status409Conflict);
        });
        api.MapPost("/document/set", (Set request) =>
        {
            string pointer = Needed(request.Pointer, "pointer");
            return Answers.Json(new { revision = document.Change(JsonPointer.Last(pointer), request.Gesture, text => Changed(text, request, pointer)) });
        });
        api.MapPost("/document/undo", () =>
        {
            document.Undo();
            return Answers.Done(session);
        });
        api.MapPost("/document/redo", () =>
        {
            document.Redo();
            return Answers.Done(session);
        });
    }

    private static void MapThings(RouteGroupBuilder api, StudioSession session)
    {
        SceneDocument document = session.Document;
        api.MapPost("/document/add", (Add request) =>
        {
            (string family, string type) = (Needed(request.Family, "family"), Needed(request.Type, "type"));
            return Pointed(document, $"add {type}", text => SceneThings.Add(text, family, type, request.Near, request.File)).Answer;
        });
        api.MapPost("/document/duplicate", (At request) =>
        {
            string pointer = Needed(request.Pointer, "pointer");
            return Pointed(document, "duplicate", text => SceneThings.Duplicate(text, pointer)).Answer;
        });
        api.MapPost("/document/rename", (Rename request) =>
        {
            (string pointer, string name) = (Needed(request.Pointer, "pointer"), Needed(request.Name, "name"));
            bool isSelected = session.Selection.Pointer == pointer;
            (IResult answer, string renamed) = Pointed(document, "rename", text => SceneThings.Rename(text, pointer, name));
            if (isSelected)
            {
                session.Selection.Select(renamed);
            }

            return answer;
        });
        api.MapPost("/document/delete", (Many request) =>
        {
            string[] pointers = Needed(request.Pointers, "pointers");
            IReadOnlyList<string> notes = [];
            int revision = document.Change("delete", null, text =>
            {
                (text, notes) = SceneThings.Delete(text, pointers);
                return text;
            });

            // The pointers of what follows have changed.
            session.Selection.Select(null);
            if (notes.Count > 0)
            {
                session.Notices.Tell("info", string.Join("; ", notes));
            }

            return Answers.Json(new { revision, notes });
        });
        api.MapPost("/document/place", (Place request) =>
        {
            string pointer = Needed(request.Pointer, "pointer");
            return Answers.Json(new { revision = document.Change("place", request.Gesture, text => Placed(text, request, pointer)) });
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

    // First scaled, then turned, then moved.
    private static JsonText Placed(JsonText text, Place place, string pointer)
    {
        text = place.Scale is { } factors ? ShapePlacement.Scale(text, pointer, factors, place.Center) : text;
        text = place.Rotate is { } turn ? ShapePlacement.Rotate(text, pointer, turn.Axis, turn.Degrees, turn.Center ?? place.Center) : text;
        return place.Translate is { } by ? ShapePlacement.Translate(text, pointer, by) : text;
    }

    private static (IResult Answer, string Pointer) Pointed(SceneDocument document, string label, Func<JsonText, (JsonText, string)> change)
    {
        string pointer = "";
        int revision = document.Change(label, null, text =>
        {
            (text, pointer) = change(text);
            return text;
        });
        return (Answers.Json(new { revision, pointer }), pointer);
    }
}
