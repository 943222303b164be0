using System.Text.Json;
using RayTracer.Scenes;
using RayTracer.Session;
using static RayTracer.Studio.DocumentRequests;

namespace RayTracer.Studio;

/// <summary>The requests that read the document and edit its text.</summary>
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
    /// <exception cref="SessionException">It has not.</exception>
    internal static T Needed<T>(T? value, string name)
        where T : class => value ?? throw new SessionException($"the request needs \"{name}\"");

    /// <summary>A list that a request must have, each of its elements.</summary>
    /// <exception cref="SessionException">It has not.</exception>
    internal static T[] Needed<T>(T?[]? values, string name)
        where T : class => values is null || values.Contains(null) ? throw new SessionException($"the request needs \"{name}\", a list without null") : [.. values.OfType<T>()];

    private static void MapReading(RouteGroupBuilder api, StudioSession session)
    {
        SceneDocument document = session.Document;
        api.MapGet("/document", () =>
        {
            (int revision, string text) = document.Current;
            return Results.Json(new { revision, text });
        });
        api.MapGet("/outline", () =>
        {
            (int revision, JsonNode root) = document.Readable;
            return Outline.Of(revision, root);
        });
        api.MapGet("/schema", () => Results.Bytes(Schema.Value, "application/json"));
        api.MapGet("/value", (string? pointer) => PropertyValues.At(document.Readable.Root, Needed(pointer, "pointer")));
        api.MapPost("/select", (Choice request) =>
        {
            if (request is { Adds: true, Pointer: { } pointer })
            {
                session.Selection.Toggle(pointer);
            }
            else
            {
                session.Selection.SelectAll(request.Pointers is null ? request.Pointer is null ? [] : [request.Pointer] : Needed(request.Pointers, "pointers"));
            }

            // The state that has it.
            return Results.Json(new { version = session.Changes.Version, revision = document.Revision });
        });
    }

    private static void MapText(RouteGroupBuilder api, StudioSession session)
    {
        SceneDocument document = session.Document;
        api.MapPost("/document/text", (Replace request) =>
        {
            bool isTaken = document.TryReplace(request.BaseRevision, request.From, request.To, Needed(request.Insert, "insert"), request.Gesture);
            (int revision, string text) = document.Current;
            return isTaken ? Results.Json(new { revision })
                : Results.Json(new { error = "The text has changed in the meantime.", revision, text }, statusCode: StatusCodes.Status409Conflict);
        });
        api.MapPost("/document/set", (Set request) => Results.Json(new { revision = Changed(session.Edits, request, Needed(request.Pointer, "pointer")) }));
        api.MapPost("/document/undo", () => document.Undo());
        api.MapPost("/document/redo", () => document.Redo());
    }

    private static void MapThings(RouteGroupBuilder api, StudioSession session)
    {
        SceneEdits edits = session.Edits;
        api.MapPost("/document/add", (Add request) => Pointed(edits.Add(Needed(request.Family, "family"), Needed(request.Type, "type"), request.File, request.At)));
        api.MapPost("/document/apply", (Apply request) =>
        {
            string what = Needed(request.Pointer, "pointer");
            return Results.Json(new { revision = request.At is { } at ? edits.Apply(what, at) : edits.Apply(what, Needed(request.Things, "things")) });
        });
        api.MapPost("/document/duplicate", (Many request) =>
        {
            (int revision, IReadOnlyList<string> pointers) = edits.Duplicate(Needed(request.Pointers, "pointers"));
            return Results.Json(new { revision, pointers });
        });
        api.MapPost("/document/rename", (Rename request) => Pointed(edits.Rename(Needed(request.Pointer, "pointer"), Needed(request.Name, "name"))));
        api.MapPost("/document/delete", (Many request) =>
        {
            (int revision, IReadOnlyList<string> notes) = edits.Delete(Needed(request.Pointers, "pointers"));
            return Results.Json(new { revision, notes });
        });
        api.MapPost("/document/place", (Place request) =>
        {
            Placement change = new(request.Translate, request.Rotate, request.Scale, request.Center);
            return Results.Json(new { revision = edits.Place(Needed(request.Pointer, "pointer"), change, request.Gesture) });
        });
    }

    private static int Changed(SceneEdits edits, Set set, string pointer)
    {
        if (set.Reset)
        {
            return edits.Reset(pointer, set.Gesture);
        }

        if (set.Json is not null)
        {
            return edits.SetText(pointer, set.Json, set.Gesture);
        }

        return set.Value.ValueKind == JsonValueKind.Undefined
            ? throw new SessionException("the request needs \"value\" or \"json\"")
            : edits.Set(pointer, System.Text.Json.Nodes.JsonNode.Parse(set.Value.GetRawText()), set.Gesture);
    }

    private static IResult Pointed((int Revision, string Pointer) edit) =>
        Results.Json(new { revision = edit.Revision, pointer = edit.Pointer });
}
