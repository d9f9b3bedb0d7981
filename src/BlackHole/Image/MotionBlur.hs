-- | The text of several scenes whose mean light is a picture with motion blur.
--
-- The text starts with the first scene, and for a single scene it contains nothing
-- else. Comments after it list the lines in which each of the other scenes differs.
module BlackHole.Image.MotionBlur
  ( maximumBlurredScenes,
    joinBlurredScenes,
    splitBlurredScenes,
  )
where

import Control.Applicative ((<|>))
import Control.Monad (guard)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)

-- | The maximum number of scenes of one picture.
maximumBlurredScenes :: Int
maximumBlurredScenes = 1024

-- | Combines several scenes, each of which ends with a newline, into one text.
joinBlurredScenes :: NonEmpty ByteString -> ByteString
joinBlurredScenes (first :| []) = first
joinBlurredScenes (first :| others) =
  first
    <> Characters.unlines
      (countMark <> decimal (1 + length others) : explanation ++ concatMap differing others)
  where
    explanation =
      map
        Characters.pack
        [ "# This picture is the mean of that many scenes. The others differ from the one",
          "# above in these lines, given by number:"
        ]
    differing text =
      let own = Characters.lines text
       in sceneMark <> decimal (length own) :
            [ Characters.concat [lineMark, decimal n, Characters.pack ":", line]
              | (n, line, before) <-
                  zip3
                    [1 :: Int ..]
                    own
                    (map Just (Characters.lines first) ++ repeat Nothing),
                before /= Just line
            ]
    decimal = Characters.pack . show

countMark, sceneMark, lineMark :: ByteString
countMark = Characters.pack "# moments "
sceneMark = Characters.pack "# moment with lines "
lineMark = Characters.pack "# "

-- | The inverse of 'joinBlurredScenes'. 'Left' holds the reason why the text cannot be split,
-- because it may come from any file. Takes time and memory proportional to the text and
-- to the scenes, which together have at most 16 MiB.
splitBlurredScenes :: ByteString -> Either String (NonEmpty ByteString)
splitBlurredScenes text = case break (countMark `Bytes.isPrefixOf`) (Characters.lines text) of
  (_, []) -> Right (text :| [])
  (first, header : rest)
    | count < 2
        || count > maximumBlurredScenes ->
      Left
        ( "motion blur is the mean of 2 to " ++ show maximumBlurredScenes ++ " scenes, not of "
            ++ show count
        )
    | count * Bytes.length original + Bytes.length text > 16777216 ->
      Left
        "the scenes of its motion blur are too long"
    | otherwise -> case traverse (changed first) (scenesIn rest) of
      Just others | length others + 1 == count -> Right (original :| others)
      _ -> Left "the list of the scenes of its motion blur is damaged"
    where
      count = maybe 0 fst (Characters.readInt (Bytes.drop (Bytes.length countMark) header))
      original = Characters.unlines first
  where
    -- The number of lines of each scene after the first, and the lines that differ.
    scenesIn lines' = case dropWhile (null . lineCount) lines' of
      line : more ->
        let (own, others) = span (null . lineCount) more
         in (sum (lineCount line), Map.fromList (mapMaybe replacement own)) : scenesIn others
      [] -> []
    lineCount line = fst <$> (Bytes.stripPrefix sceneMark line >>= Characters.readInt)
    replacement line = do
      (n, rest) <- Characters.readInt =<< Bytes.stripPrefix lineMark line
      (,) n <$> Bytes.stripPrefix (Characters.pack ":") rest
    -- Every line is either listed or taken from the first scene.
    changed first (count, replaced) = do
      guard (count <= length first + Map.size replaced)
      Characters.unlines
        <$> sequence
          [ Map.lookup n replaced <|> line
            | (n, line) <- zip [1 .. count] (map Just first ++ repeat Nothing)
          ]
