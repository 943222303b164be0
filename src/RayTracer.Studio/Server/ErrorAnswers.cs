using System.Text.Json;
using System.Text.Json.Serialization;
using RayTracer.Imaging;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>Turns what goes wrong into an answer with a sentence for the user.</summary>
/// <param name="errors">Takes the internal errors.</param>
internal sealed class ErrorAnswers(TextWriter errors)
{
    // What was asked for may stand in it, however long it was.
    private const int LongestMessage = 1000;

    /// <summary>Passes a request on.</summary>
    public async Task Invoke(HttpContext context, RequestDelegate next)
    {
        try
        {
            await next(context);
        }
        catch (Exception e) when (e is OperationCanceledException or ObjectDisposedException && context.RequestAborted.IsCancellationRequested)
        {
            // The client has gone, or the server ends.
        }
        catch (Exception e)
        {
            (int status, string message) = Describe(e);
            if (status == StatusCodes.Status500InternalServerError)
            {
                await errors.WriteLineAsync($"error: {context.Request.Method} {context.Request.Path}: {e}");
            }

            if (!context.Response.HasStarted)
            {
                context.Response.StatusCode = status;
                await context.Response.WriteAsJsonAsync(Answer(e, message), ApiJson.Options, context.RequestAborted);
            }
        }
    }

    // What is in the way, so that the page can ask the user whether to do it all the same.
    private static ErrorAnswer Answer(Exception e, string message)
    {
        SessionFault? fault = (e as SessionException)?.Fault;
        return new(message.Length > LongestMessage ? $"{message[..LongestMessage]} …" : message) { Unsaved = fault == SessionFault.Unsaved, Exists = fault == SessionFault.Exists, ChangedOnDisk = fault == SessionFault.ChangedOnDisk };
    }

    private static (int Status, string Message) Describe(Exception e) => e switch
    {
        SessionException { Fault: SessionFault.Missing } => (StatusCodes.Status404NotFound, Complaint.Of(e)!),
        SessionException { Fault: not SessionFault.Refused } => (StatusCodes.Status409Conflict, Complaint.Of(e)!),
        BadHttpRequestException bad => (bad.StatusCode, bad.InnerException is JsonException json ? $"The request's JSON is wrong: {json.Message}" : bad.Message),
        JsonException => (StatusCodes.Status400BadRequest, $"The request's JSON is wrong: {e.Message}"),
        _ => Complaint.Of(e) is { } complaint ? (StatusCodes.Status400BadRequest, complaint) : (StatusCodes.Status500InternalServerError, $"Internal error: {e.Message}"),
    };
}

/// <summary>The answer to a request that failed.</summary>
/// <param name="Error">Why, in a sentence for the user.</param>
internal sealed record ErrorAnswer(string Error)
{
    /// <summary>Returns whether unsaved changes would be lost.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingDefault)]
    public bool Unsaved { get; init; }

    /// <summary>Returns whether the file exists already.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingDefault)]
    public bool Exists { get; init; }

    /// <summary>Returns whether somebody else has changed the file.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingDefault)]
    public bool ChangedOnDisk { get; init; }
}
