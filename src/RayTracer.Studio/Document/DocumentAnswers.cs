using System.Text.Json;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>Reads requests and writes answers of the document's endpoints.</summary>
internal static class DocumentAnswers
{
    private static readonly JsonSerializerOptions s_options = new(JsonSerializerDefaults.Web);

    /// <summary>The body of a request.</summary>
    /// <exception cref="DocumentException">It is not what is expected.</exception>
    public static async Task<T> Body<T>(HttpContext context)
        where T : class
    {
        try
        {
            return await JsonSerializer.DeserializeAsync<T>(context.Request.Body, s_options, context.RequestAborted)
                ?? throw new DocumentException("the request has no content");
        }
        catch (JsonException e)
        {
            throw new DocumentException($"the request is not as expected: {e.Message.ReplaceLineEndings(" ").TrimEnd('.')}", e);
        }
    }

    /// <summary>An answer in JSON.</summary>
    public static IResult Json(object value, int status = StatusCodes.Status200OK) => Results.Json(value, s_options, statusCode: status);

    /// <summary>A value as JSON.</summary>
    public static byte[] Bytes(object value) => JsonSerializer.SerializeToUtf8Bytes(value, s_options);

    /// <summary>Something that a request must have.</summary>
    /// <exception cref="DocumentException">It has not.</exception>
    public static string Needed(string? value, string name) => value ?? throw new DocumentException($"the request needs \"{name}\"");

    /// <summary>Turns what cannot be done into an answer that says so.</summary>
    public static async ValueTask<object?> Guard(EndpointFilterInvocationContext context, EndpointFilterDelegate next)
    {
        try
        {
            return await next(context);
        }
        catch (DocumentException e)
        {
            Dictionary<string, object> answer = new(StringComparer.Ordinal) { ["error"] = e.Message };
            if (e.Conflict != DocumentConflict.None)
            {
                answer[JsonNamingPolicy.CamelCase.ConvertName(e.Conflict.ToString())] = true;
            }

            return Json(answer, e.Conflict == DocumentConflict.None ? StatusCodes.Status400BadRequest : StatusCodes.Status409Conflict);
        }
    }
}
