-- | The scenes whose mean light one picture is, in one text.
--
-- The text is that of the first scene, and for a single one no more than that.
-- Comments after it tell in which lines the others differ.
module BlackHole.Image.Moments
  ( joinMoments,
    splitMoments,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Characters
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)

-- | One text of several, each of which ends in a line's end.
joinMoments :: NonEmpty ByteString -> ByteString
joinMoments (first :| []) = first
joinMoments (first :| others) =
  first <> Characters.unlines (Characters.pack (mark ++ show (1 + length others)) : explanation ++ concatMap differing others)
  where
    explanation = map Characters.pack ["# The picture is the mean light of so many scenes. The others differ from the", "# one above in these lines, by their numbers:"]
    differing text =
      let own = Characters.lines text
       in Characters.pack (momentMark ++ show (length own)) :
            [ Characters.pack ("# " ++ show n ++ ":") <> line
              | (n, line, before) <- zip3 [1 :: Int ..] own (map Just (Characters.lines first) ++ repeat Nothing),
                before /= Just line
            ]

mark, momentMark :: String
mark = "# moments "
momentMark = "# moment with lines "

-- | The texts again.
splitMoments :: ByteString -> NonEmpty ByteString
splitMoments text = case break (Characters.isPrefixOf (Characters.pack mark)) (Characters.lines text) of
  (_, []) -> text :| []
  (first, _ : rest) -> Characters.unlines first :| map (changed first) (moments rest)
  where
    moments rest = case dropWhile (null . count) rest of
      [] -> []
      line : more ->
        let (own, others) = span (null . count) more
         in (sum (count line), Map.fromList (mapMaybe replacement own)) : moments others
    count line = maybe [] (maybe [] (pure . fst) . Characters.readInt) (Characters.stripPrefix (Characters.pack momentMark) line)
    replacement line = do
      (n, rest) <- Characters.readInt =<< Characters.stripPrefix (Characters.pack "# ") line
      (,) n <$> Characters.stripPrefix (Characters.pack ":") rest
    changed first (count', replaced) =
      Characters.unlines [Map.findWithDefault line n replaced | (n, line) <- zip [1 .. min 1000000 count'] (first ++ repeat Characters.empty)]
